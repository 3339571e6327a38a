#pragma once
// Orbits that come in families because free parts may be anywhere.

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "methods/orbit/orbit_equations.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

/// Whether a contact presses or is struck. Motions that touch nothing are families of another kind, of any
/// mean within the clearances, and asked for apart (polish_free_member).
inline bool touches(const OrbitGuess& path) {
  return !path.events.empty() || std::ranges::find(path.start.closed, true) != path.start.closed.end();
}

/// A Jacobian of OrbitEquations where orbits are not isolated.
struct FamilyInverse {
  Eigen::MatrixXd inverse;  ///< J^+, the steps that leave the place in the family alone
  double condition = 1.0;   ///< of J without the family [-]
};

/// Condition of a Jacobian, reciprocal, from which on it is asked for a family: beyond it a step is rounding
/// [-].
inline constexpr double kFamilyCondition = 1e-12;

/// The pseudo-inverse of a Jacobian J that is singular for nothing but displacements at rest: no velocity and
/// no instant of an event changes along them, as where a gear pair turns as one, or nothing touches.
/// Equations of an orbit stay solvable there. Nothing for any other J: to 1e-9 of its largest singular value,
/// 1e-6 of a direction's length. \param states  Ns, of which the first half at least are displacements
inline std::optional<FamilyInverse> family_inverse(const Eigen::MatrixXd& J, Eigen::Index states) {
  constexpr double kSingular = 1e-9, kAtRest = 1e-6;
  const SingularValues found = singular_vectors(J);
  const Eigen::Index rank = (found.values.array() > kSingular * found.values[0]).count();
  const Eigen::MatrixXd family = found.V.rightCols(found.values.size() - rank);
  if (rank == 0 || family.cols() == 0 || family.bottomRows(J.cols() - states / 2).norm() > kAtRest)
    return std::nullopt;
  return FamilyInverse{.inverse = found.V.leftCols(rank) *
                                  found.values.head(rank).cwiseInverse().asDiagonal() *
                                  found.U.leftCols(rank).transpose(),
                       .condition = found.values[0] / found.values[rank - 1]};
}

}  // namespace signorini
