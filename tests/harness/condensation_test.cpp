#include "methods/kernels/condensation.hpp"

#include <gtest/gtest.h>

#include "harness/reference.hpp"
#include "methods/kernels/periodic_response.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

SparseMatrix sparse(const Eigen::MatrixXd& dense) { return dense.sparseView(); }

/// Mass 1 on springs to the wall and to a massless node that may touch the stop.
Problem massless_node(double gap = 0.2) {
  Problem problem = test::one_mass();
  problem.mass = sparse(Eigen::Vector2d(1.0, 0.0).asDiagonal());
  problem.damping = sparse(Eigen::Vector2d(0.1, 0.0).asDiagonal());
  problem.stiffness = sparse((Eigen::Matrix2d() << 1.0 + 20.0, -20.0, -20.0, 20.0).finished());
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = gap}};
  problem.law = Massless{};
  return problem;
}

TEST(Condense, TurnsAMasslessNodeIntoASpringStop) {
  const CondensedScene scene = condense(massless_node());
  ASSERT_TRUE(scene.problem.has_value()) << scene.reason;
  const Problem& condensed = *scene.problem;
  EXPECT_EQ(condensed.size(), 1);
  EXPECT_NEAR(condensed.stiffness.coeff(0, 0), 1.0, 1e-14);
  EXPECT_EQ(std::get<Penalty>(condensed.law).stiffness, (std::vector<double>{20.0}));
  EXPECT_EQ(condensed.contacts[0].normal, (std::vector<std::pair<int, double>>{{0, 1.0}}));
  EXPECT_EQ(condensed.contacts[0].gap, 0.2);
}

TEST(Condense, SaysWhereItCannotBeDone) {
  Problem damped = massless_node();
  damped.damping = sparse((Eigen::Matrix2d() << 0.1, -0.1, -0.1, 0.1).finished());
  EXPECT_EQ(condense(damped).reason, "a massless contact is damped");
  Problem loaded = massless_node();
  loaded.force.front().dof = 1;
  EXPECT_EQ(condense(loaded).reason, "a load acts on a massless contact");
  Problem spread = massless_node();
  spread.contacts[0].normal = {{0, 0.5}, {1, 0.5}};
  EXPECT_FALSE(condense(spread).problem.has_value());
}

TEST(EventDrivenOrbits, SatisfyTheEquationsOfTheMasslessScene) {
  const Problem problem = massless_node();
  const Reference reference =
      compute_reference(problem, event_driven_orbits(), std::chrono::steady_clock::time_point::max());
  ASSERT_NE(reference.orbit, nullptr) << reference.reason;
  const Samples samples = reference.orbit->sample(kGrid);
  EXPECT_LE(samples.x.maxCoeff(), 0.2);
  EXPECT_LT(samples.force.minCoeff(), 0.0);
  // x = W^T Z^-1 (f + W lambda) holds in the original scene, contact node included.
  const Eigen::VectorXd x = PeriodicResponse(problem, *reference.orbit).displacement(1024).col(1);
  const Samples coarse = reference.orbit->sample(1024);
  // Summed to 512 harmonics; those of a force with kinks fall like 1/n^2, which leaves some 512^-3/2 of it.
  EXPECT_LT((x - coarse.x.col(0)).norm() / coarse.x.norm(), 5e-5);
}

}  // namespace
}  // namespace signorini
