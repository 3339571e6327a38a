#pragma once
// Follows one curve of harmonic balance by arc length.

#include <Eigen/Core>
#include <vector>

#include "methods/continuation/curve_tracer.hpp"
#include "methods/harmonic_balance/continuation/series_steps.hpp"

namespace signorini {

/// A branch, its unknowns labelled by their intervals of contact, and curves that begin at its doublings and
/// branch points.
struct TracedSeries : TracedBranch<SeriesStart> {
  /// Unknowns where a motion without contact first touches.
  std::vector<Eigen::VectorXd> grazings = {};
};

/// Follows a curve by the steps of SeriesSteps, both folds and gains or losses of contact included.
///
/// Located on each step, to rounding of the method's own equations: folds (the frequency's component of the
/// tangent is zero), branch points (det [R_x; tangent^T]), period doublings (doubled_jacobian), and where a
/// contact begins to press or ceases to. Doublings and branch points are starts of other curves.
///
/// Where steps fall below the shortest the branch has broken: `ended` says at which frequency. A motion of
/// several periods ends where it becomes one of a smaller period.
///
/// \param followed   may end the curve
/// \param doublings  whether these are looked for
TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
                          const FollowedCurves& followed, bool doublings);

}  // namespace signorini
