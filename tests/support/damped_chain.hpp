#pragma once
// A chain of unequal masses with proportional damping, loads and contacts: small enough for dense algebra.

#include <Eigen/LU>
#include <complex>

#include "problems/problem.hpp"

namespace signorini::test {

/// Masses 1, 1.1, 1.2, ... between springs, the first held to the ground; D = 0.05 M + 0.01 K; loads of
/// harmonics 0, 1 and 3; contacts on the last mass, on the difference of the first two, and so on, one per
/// `spacing`.
inline Problem damped_chain(int masses, int contacts = 2) {
  Problem problem;
  problem.name = "chain";
  problem.kind = "chain";
  problem.edit_structure([masses](Structure& s) {
    s.mass = SparseMatrix(masses, masses);
    s.stiffness = SparseMatrix(masses, masses);
    for (int i = 0; i < masses; ++i) {
      s.mass.insert(i, i) = 1.0 + 0.1 * i;
      s.stiffness.insert(i, i) = 2.0 + 0.3 * i;
      if (i + 1 == masses) continue;
      s.stiffness.insert(i, i + 1) = -1.0;
      s.stiffness.insert(i + 1, i) = -1.0;
    }
    s.damping = 0.05 * s.mass + 0.01 * s.stiffness;
  });
  problem.frequency = 1.3;
  problem.force = {{0, 1, 1.0, 0.5}, {masses - 1, 3, 0.0, 0.7}, {0, 0, 0.25, 0.0}};
  for (int j = 0; j < contacts; ++j)
    problem.contacts.push_back({{{j % masses, 1.0}, {(j + 1) % masses, -0.5}}, 0.1 + 0.01 * j});
  problem.set_law(Restitution{1.0});
  return problem;
}

/// Z = mass M + damping D + stiffness K, dense.
inline Eigen::MatrixXcd dense_stiffness(const Problem& problem, std::complex<double> mass,
                                        std::complex<double> damping, std::complex<double> stiffness) {
  return mass * Eigen::MatrixXd(problem.mass()) + damping * Eigen::MatrixXd(problem.damping()) +
         stiffness * Eigen::MatrixXd(problem.stiffness());
}

}  // namespace signorini::test
