#pragma once
// Follows one curve of the contact condition on hat functions, from one set of pressing nodes to the next.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "methods/continuation/curve_tracer.hpp"
#include "methods/hat_functions/continuation/hat_curve.hpp"

namespace signorini {

/// Where a curve begins and where it goes.
struct HatStart {
  int multiple = 1;           ///< of the period of the scene's order
  std::vector<int> pressing;  ///< S
  Eigen::VectorXd x;          ///< on the curve of S
  Eigen::VectorXd tangent;    ///< the first step is taken along it
  std::string origin;         ///< why there, one clause

  [[nodiscard]] int periods() const { return multiple; }  ///< of the scene's order
};

/// Follows a curve by pseudo-arclength steps while the set of pressing nodes is the same; where a pressure or
/// an open gap becomes zero, located to rounding, that node joins or leaves the set and the curve goes on
/// with the new one: parametric pivoting. The parameter is the length, so that a set may be left in either
/// direction of the frequency. Each change of direction of the frequency is a fold, within a set or at a
/// change of it. A change that leaves nothing pressing, or begins with nothing, is a contact change (a
/// grazing of rigid stops).
///
/// On rigid stops that carry mass the phase of an impact is that of a node: a branch is a staircase whose
/// steps are of the size of the grid's. Folds between which the frequency goes back by less than a share 1 /
/// N of itself are those of the grid, and left out.
///
/// \param followed  may end the curve
/// \return the branch, its unknowns those of all nodes; `others` are where a motion without contact first
///         touches, still without
TracedBranch<HatStart> trace_hat(const HatFamily& family, const HatStart& start, const CurveLimits& limits,
                                 const FollowedCurves& followed);

/// The tangent of the curve of S where it is evaluated, on the side where a gap opens or a pressure grows.
/// \param changed  a node that has joined S, or left it
/// Empty where the set is degenerate there.
std::optional<Eigen::VectorXd> tangent_after_change(HatCurve& curve, int changed);

}  // namespace signorini
