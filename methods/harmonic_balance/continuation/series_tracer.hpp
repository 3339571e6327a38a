#pragma once
// Follows one curve of harmonic balance by arc length.

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "methods/continuation/curve_points.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/continuation/series_steps.hpp"

namespace signorini {

/// Whether unknowns, with so many intervals of contact, lie on a branch followed before.
using KnownSeries = std::function<bool(const Eigen::VectorXd& x, std::size_t intervals)>;

/// A branch, its unknowns, and the starts of others.
struct TracedSeries {
  Branch branch;
  int multiple = 1;
  CurvePoints points = {};    ///< unknowns and tangents of each, labelled by their intervals of contact
  std::string rejected = {};  ///< the curve fell back on the one it was to leave; to be dropped
  std::vector<SeriesStart> others = {};  ///< curves that begin at its doublings and branch points
  /// Unknowns where a motion without contact first touches.
  std::vector<Eigen::VectorXd> grazings = {};
};

/// Follows a curve by the steps of SeriesSteps, both folds and gains or losses of contact included.
///
/// Located on each step, to rounding of the method's own equations: folds (the frequency's component of the
/// tangent is zero), branch points (det [R_x; tangent^T]), period doublings (doubled_jacobian), and where a
/// contact begins to press or ceases to. Doublings and branch points are starts of other curves.
///
/// Where steps fall below the smallest the branch has broken: `ended` says at which frequency. A motion of
/// several periods ends where it becomes one of a smaller period.
///
/// \param doublings  whether these are looked for
/// \param known      may end the curve
TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
                          bool doublings, const KnownSeries& known);

}  // namespace signorini
