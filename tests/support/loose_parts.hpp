#pragma once
// Scenes of parts that no spring holds, with closed forms and the results of an independent flow.

#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// One mass on no spring, K = 0.
inline Problem loose_mass(double mass, double damping) {
  const auto scalar = [](double value) {
    SparseMatrix matrix(1, 1);
    matrix.insert(0, 0) = value;
    matrix.makeCompressed();
    return matrix;
  };
  Problem problem;
  problem.name = "loose-mass";
  problem.title = "One mass on no spring";
  problem.kind = "sdof";
  problem.edit_structure([&](Structure& s) {
    s.mass = scalar(mass);
    s.damping = scalar(damping);
    s.stiffness = scalar(0.0);
  });
  return problem;
}

/// A gear pair as one mass in its backlash (Kahraman and Singh 1990): m = 1, D = 0.1, teeth k = 1 at x = 1
/// and x = -1, the load 0.1 + 0.05 w^2 cos w t. At w = 0.9 stretches in closed form, from rest, end at
/// 0.8392488693 <= x <= 1.2975814541, multipliers of modulus 0.705347.
inline Problem gear_backlash() {
  Problem problem = loose_mass(1.0, 0.1);
  problem.frequency = 0.9;
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 0.1}, {.dof = 0, .cos = 0.05, .omega_power = 2}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}, {.normal = {{0, -1.0}}, .gap = 1.0}};
  problem.set_law(Penalty{.stiffness = {1.0, 1.0}});
  return problem;
}

/// A ball on a table that moves by A cos w t, A = 0.05 m, e = 0.8, told from the table, x towards it: m = 1,
/// the load g - A w^2 cos w t. Each period it bounces once, with the impulse m g T (Holmes 1982).
inline Problem bouncing_ball() {
  Problem problem = loose_mass(1.0, 0.0);
  problem.frequency = 14.142135623730951;
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 9.81}, {.dof = 0, .cos = -0.05, .omega_power = 2}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.0}};
  problem.set_law(Restitution{0.8});
  return problem;
}
inline constexpr double kBallImpulse = 4.358468162333357;  ///< m g T of the last [N s]

}  // namespace signorini::test
