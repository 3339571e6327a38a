#pragma once
// Follows one curve of the contact condition on hat functions, from one set of pressing nodes to the next.

#include <Eigen/Core>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "methods/continuation/curve_points.hpp"
#include "methods/hat_functions/continuation/hat_curve.hpp"
#include "methods/orbit/continuation/branch.hpp"

namespace signorini {

/// How far and how finely a curve is followed. Lengths are in the units of HatCurve.
struct HatCurveOptions {
  double first_step = 0.01;     ///< length of the first step
  double largest_step = 0.1;    ///< and of any
  double smallest_step = 1e-7;  ///< below, the curve has broken
  int max_points = 2000;        ///< per branch
  int max_changes = 20000;      ///< of the set of pressing nodes, per branch
  int phases = 0;               ///< of a forcing period at which the points keep their motion
  std::vector<double> at = {};  ///< frequencies at which the curve has points [rad/s]
  /// Whether unknowns of all nodes lie on a branch followed before, which ends the curve.
  std::function<bool(const Eigen::VectorXd& all)> known = {};
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Where a curve begins and where it goes.
struct HatStart {
  int multiple = 1;           ///< of the period of the scene's order
  std::vector<int> pressing;  ///< S
  Eigen::VectorXd x;          ///< on the curve of S
  Eigen::VectorXd tangent;    ///< the first step is taken along it
  std::string origin;         ///< why there, one clause
};

/// A branch and its unknowns.
struct TracedHat {
  Branch branch;
  int multiple = 1;
  CurvePoints points = {};              ///< unknowns of all nodes, and tangents
  std::vector<HatStart> grazings = {};  ///< where a motion without contact first touches, still without
};

/// Follows a curve by pseudo-arclength steps while the set of pressing nodes is the same; where a pressure or
/// an open gap becomes zero, located to rounding, that node joins or leaves the set and the curve goes on
/// with the new one: parametric pivoting. The parameter is the length, so that a set may be left in either
/// direction of the frequency. Each change of direction of the frequency is a fold, within a set or at a
/// change of it. A change that leaves nothing pressing, or begins with nothing, is a contact change (a
/// grazing of rigid stops).
///
/// On rigid stops that carry mass the phase of an impact is that of a node: a branch is a staircase whose
/// steps are of the size of the grid's, with folds that are those of the grid.
TracedHat trace_hat(const HatFamily& family, const HatStart& start, const HatCurveOptions& options);

/// The tangent of the curve of S where it is evaluated, on the side where a gap opens or a pressure grows.
/// \param changed  a node that has joined S, or left it
/// Empty where the set is degenerate there.
std::optional<Eigen::VectorXd> tangent_after_change(HatCurve& curve, int changed);

}  // namespace signorini
