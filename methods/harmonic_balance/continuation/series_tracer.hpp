#pragma once
// Follows one curve of harmonic balance by arc length.

#include <Eigen/Core>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "methods/continuation/curve_points.hpp"
#include "methods/harmonic_balance/continuation/series_switching.hpp"
#include "methods/orbit/continuation/branch.hpp"

namespace signorini {

/// How far and how finely a curve is followed. Lengths are in the units of SeriesCurve.
struct SeriesCurveOptions {
  double first_step = 0.01;     ///< length of the first step
  double largest_step = 0.1;    ///< and of any
  double smallest_step = 1e-6;  ///< below, the curve has broken
  double largest_motion = 60;   ///< |x| beyond which a branch counts as unbounded
  int max_points = 2000;        ///< per branch
  bool doublings = true;        ///< look for motions of twice the period
  int phases = 0;               ///< of a forcing period at which the points keep their motion
  std::vector<double> at = {};  ///< frequencies at which the curve has points [rad/s]
  /// Whether unknowns lie on a branch followed before, which ends the curve.
  std::function<bool(const Eigen::VectorXd& x)> known = {};
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// A branch, its unknowns, and the starts of others.
struct TracedSeries {
  Branch branch;
  int multiple = 1;
  CurvePoints points = {};               ///< unknowns and tangents of each
  std::string rejected = {};             ///< the curve fell back on the one it was to leave; to be dropped
  std::vector<SeriesStart> others = {};  ///< curves that begin at its doublings and branch points
  /// Unknowns where a motion without contact first touches.
  std::vector<Eigen::VectorXd> grazings = {};
};

/// Follows a curve by pseudo-arclength steps, both folds and gains or losses of contact included: with the
/// exact contact integral the equations are continuously differentiable there. A step is refused where the
/// tangent turns by more than .35 rad, where Newton's method leads farther than twice its length, or where
/// the motion itself changes by more than a tenth.
///
/// Located on each step, to rounding of the method's own equations: folds (the frequency's component of the
/// tangent is zero), branch points (det [R_x; tangent^T]), period doublings (doubled_jacobian), and where a
/// contact begins to press or ceases to. Doublings and branch points are starts of other curves.
///
/// Where the curve turns on a radius below any step, as it does where a second contact is born on a motion
/// with impacts, the next point is sought along the response to a small impulse at the nearest approach to a
/// stop, and must press there (press_further). Where that fails too the branch has broken: `ended` says at
/// which frequency. A motion of several periods ends where it becomes one of a smaller period.
TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start,
                          const SeriesCurveOptions& options);

}  // namespace signorini
