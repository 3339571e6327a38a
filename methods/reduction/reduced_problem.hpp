#pragma once
// A reduced structure as a scene of its own.

#include <string>

#include "methods/structure/bases/reduced_structure.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Why springs beside massless contacts are not reduced: a spring has no static residual that relaxes, a
/// massless contact is nothing without.
inline constexpr const char* kMixedRelaxing =
    "springs beside massless contacts are not reduced where the damping grows with the stiffness";

/// A scene on few coordinates, or why there is none.
struct ReducedProblem {
  std::string obstacle = {};  ///< one clause; empty: none
  Problem problem = {};       ///< where there is no obstacle
};

/// The equations of a ContactReduction as matrices of m + Nc coordinates (q, x), the contacts x without mass:
///
///     M = [1, 0; 0, 0],   K = [omega^2 + n G n^T, -n G; -G n^T, G],   D = alpha M + beta K,   G = C_m^-1,
///     f = (phi^T f - n G s_m, G s_m),
///
/// so that G (1 + beta d/dt) (x - n^T q) = G s_m + lambda, which is what xi obeys, and n lambda acts on q.
/// Gaps, stiffness of springs, frequency and order of the motion are those of the scene. Coordinates from m
/// on are the contacts with a static residual, in their order. A spring without one, its residual within
/// 1e-12 of what the vectors give way by, acts on the vectors: x = n^T q.
///
/// An obstacle: contacts with mass and an impact law, which the reduced structure does not represent
/// (march_obstacle); kMixedRelaxing; a static residual C_m that is not definite to 1e-12 of its diagonal.
ReducedProblem reduced_problem(const Problem& scene, const ContactReduction& reduction);

}  // namespace signorini
