#pragma once
// A point where two curves of orbits cross, by equations that are regular there.

#include <Eigen/Core>
#include <optional>

#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

/// A simple branch point: [R_x], n x (n + 1), has rank n - 1 there.
struct BranchPointSolution {
  Eigen::VectorXd x = {};  ///< n + 1, in CurveUnits
  /// The unit tangents of the curves that cross, those a of the null space of [R_x] with psi^T R_xx[a, a] =
  /// 0, psi^T R_x = 0.
  Eigen::VectorXd first = {}, second = {};
};

/// The branch point next to x, of driven motions. On a curve's own equations Newton's method is singular
/// there and the point is known to the root of rounding; solved is, in the unknowns x and nu, n + 2 of them,
///
///     R(x) + nu b = 0,   g(x) = 0,   [R_x b; C^T 0] [V; g] = [0; 1],
///
/// b, n, and C, (n + 1) x 2, the singular vectors of [R_x] at the beginning: g, 1 x 2, vanishes where the
/// rank is n - 1, and the system is regular where the curves cross at an angle. The derivative of g is taken
/// by central differences along C and kept. dR/dp by a difference of fourth order, for here its error moves
/// the point.
///
/// \param equations  left evaluated at the point
/// \param reach      largest distance from x at which the point is still that [CurveUnits]
/// \return empty where Newton's method fails or leaves the reach, where nu does not vanish to rounding, as of
///         two curves that pass each other, or where the curves do not cross at an angle
std::optional<BranchPointSolution> solve_branch_point(ExtendedEquations& equations, const Eigen::VectorXd& x,
                                                      double reach);

}  // namespace signorini
