#include "methods/structure/bases/massless_elimination.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "problems/linear_algebra/lu.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::massless_elimination_test {
namespace {

// The oracle: all coordinates without mass solved for at once, densely, under unit displacements of the
// others, unit forces and the load.
TEST(EliminateMassless, IsTheStaticResponseOfTheMasslessCoordinates) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Problem problem = test::coupled_massless_scene(seed);
    const MasslessElimination seen = eliminate_massless(problem);
    ASSERT_EQ(seen.obstacle, "");
    ASSERT_EQ(seen.kept.size() + seen.massless.size(), static_cast<std::size_t>(problem.size()));
    for (const int dof : seen.massless) EXPECT_EQ(problem.mass().coeff(dof, dof), 0.0);
    const Eigen::MatrixXd K(problem.stiffness()), W(contact_directions(problem));
    const Eigen::MatrixXd K_bb = K(seen.massless, seen.massless);
    const LuFactors stiffness(K_bb);
    const Eigen::MatrixXd W_b = W(seen.massless, Eigen::all), K_bi = K(seen.massless, seen.kept);
    const Eigen::MatrixXd N =
        Eigen::MatrixXd(W(seen.kept, Eigen::all)) - K_bi.transpose() * stiffness.solve(W_b);
    EXPECT_LT((Eigen::MatrixXd(seen.normals) - N).norm(), 1e-13 * N.norm());
    EXPECT_LT((seen.massless_compliance - W_b.transpose() * stiffness.solve(W_b)).norm(),
              1e-13 * seen.massless_compliance.norm());
    for (std::size_t h = 0; h < seen.rates.size(); ++h) {
      const auto column = static_cast<Eigen::Index>(h);
      const Eigen::VectorXcd f = load_harmonic(problem, static_cast<int>(h));
      const Eigen::VectorXcd f_b = f(seen.massless);
      const Eigen::MatrixXcd inverse = stiffness.inverse().cast<std::complex<double>>();
      const Eigen::VectorXcd moved = inverse * f_b;
      EXPECT_LT((seen.shift.col(column) - W_b.transpose() * moved).norm(), 1e-12 * f.norm());
      const Eigen::VectorXcd left = f(seen.kept);
      EXPECT_LT((seen.load.col(column) - left + K_bi.transpose() * moved).norm(), 1e-12 * f.norm());
    }
  }
}

TEST(EliminateMassless, LeavesAStructureWithMassEverywhereAsItIs) {
  const Problem problem = test::stopped_chain(5, 0.5, 2);
  const MasslessElimination seen = eliminate_massless(problem);
  EXPECT_TRUE(seen.massless.empty());
  EXPECT_EQ((Eigen::MatrixXd(seen.normals) - Eigen::MatrixXd(contact_directions(problem))).norm(), 0.0);
  EXPECT_TRUE(seen.massless_compliance.isZero(0.0));
  EXPECT_TRUE(seen.shift.isZero(0.0));
  EXPECT_EQ(seen.rates.front(), 0.0);
}

TEST(EliminateMassless, SaysWhereNothingHoldsThem) {
  Problem problem = test::massless_node();
  problem.edit_structure([](Structure& s) {
    s.stiffness = Eigen::MatrixXd((Eigen::Matrix2d() << 1.0, 0.0, 0.0, 0.0).finished()).sparseView();
  });
  EXPECT_EQ(eliminate_massless(problem).obstacle, "coordinates without mass have no stiffness of their own");
}

}  // namespace
}  // namespace signorini::massless_elimination_test
