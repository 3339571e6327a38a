#include "tests/support/exact_scenes.hpp"

#include <Eigen/Core>

#include "problems/assembly/chain.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

Problem skew_damped_pair(double restitution, double frequency) {
  Problem problem;
  problem.name = "skew-damped-pair";
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Vector2d(1.0, 0.6).asDiagonal()).sparseView();
    s.stiffness = Eigen::MatrixXd((Eigen::Matrix2d() << 2.5, -1.2, -1.2, 1.2).finished()).sparseView();
    s.damping = Eigen::MatrixXd((Eigen::Matrix2d() << 0.25, -0.02, -0.02, 0.05).finished()).sparseView();
  });
  problem.frequency = frequency;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 0.6, .sin = 0.3},
                   {.dof = 1, .harmonic = 2, .cos = 0.0, .sin = 0.2}};
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 0.5}};
  problem.set_law(Restitution{restitution});
  return problem;
}

Problem penalty_oscillator(double penalty, double frequency, double gap) {
  Problem problem = to_problem({.damping = 0.1, .frequency = frequency, .gap = gap});
  problem.set_law(Penalty{.stiffness = {penalty}});
  return problem;
}

Problem stopped_chain(int masses, double restitution, int stops, double frequency) {
  Chain chain;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(1.0 + 0.2 * i);
    chain.springs.push_back(2.0 - 0.1 * i);
    chain.dampers.push_back(0.08 + 0.03 * (i % 2));
  }
  const Structure structure = assemble(chain);
  Problem problem;
  problem.name = "stopped-chain";
  problem.structure = std::make_shared<const Structure>(structure);
  problem.frequency = frequency;
  problem.force = {{.dof = masses - 1, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  for (int j = 0; j < stops; ++j)
    problem.contacts.push_back({.normal = {{masses - 1 - j, 1.0}}, .gap = 0.4 + 0.2 * j});
  problem.set_law(Restitution{restitution});
  return problem;
}

}  // namespace signorini::test
