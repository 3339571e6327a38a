#include "methods/aft_hbm/aft_grid_solver.hpp"

#include <gtest/gtest.h>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::aft_grid_solver_test {
namespace {

/// The oscillator "S-A" under the Lipschitz law, ten harmonics on 320 samples.
struct Scene {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  ContactReceptance receptance = fourier_receptance(problem, 10);
  Eigen::VectorXd gap = contact_gaps(problem);
  ProjectedLaw law = lipschitz_law(problem, {}, receptance);

  [[nodiscard]] GridSolution solve(const GridSolver& solver, Work& work,
                                   const Eigen::MatrixXcd& previous = {}) const {
    return solver({receptance, gap, law}, 320, previous, {}, work);
  }
};

TEST(AftGridSolver, FindsWhatPivotingFinds) {
  const Scene scene;
  Work work, pivots;
  const GridSolution aft = scene.solve(aft_grid_solver({}), work);
  const GridSolution lcp = scene.solve(lcp_grid_solver({}), pivots);
  ASSERT_TRUE(aft.solved) << aft.message;
  ASSERT_TRUE(lcp.solved) << lcp.message;
  EXPECT_LE((aft.lambda - lcp.lambda).norm(), 1e-8 * lcp.lambda.norm());
  EXPECT_EQ(aft.message, "gap homotopy and Newton-Krylov");
}

TEST(AftGridSolver, GoesOnFromTheGridBefore) {
  const Scene scene;
  Work cold, warm;
  const GridSolution first = scene.solve(aft_grid_solver({}), cold);
  const GridSolution second = scene.solve(aft_grid_solver({}), warm, first.lambda);
  ASSERT_TRUE(second.solved);
  EXPECT_EQ(second.message, "Newton-Krylov");
  EXPECT_LE(warm.iterations.value(), 1);
  EXPECT_FALSE(warm.pivots);
}

TEST(AftGridSolver, AsksForNoFinerGridWhereNewtonAloneHasLostItsWay) {
  const Scene scene;
  Work work;
  const GridSolution alone = scene.solve(aft_grid_solver({}, false), work);
  EXPECT_FALSE(alone.solved);
  EXPECT_FALSE(alone.finer_may_help);
  EXPECT_EQ(alone.message, "Newton-Krylov found no descent");
}

TEST(AftGridSolver, KeepsWithinItsLimit) {
  const Scene scene;
  Work work;
  const GridSolution limited = scene.solve(aft_grid_solver({.max_iterations = 6}), work);
  EXPECT_FALSE(limited.solved);
  EXPECT_LE(work.iterations.value() + work.pivots.value_or(0), 6);
}

TEST(AftGridSolver, ReportsNewtonStepsOfEverySolve) {
  const Problem pressed =
      test::to_problem({.damping = 0.1, .frequency = 0.6, .gap = -1.5, .restitution = 1.0});
  const Solution aft = test::solve<AftHbm>(pressed, {});
  EXPECT_EQ(aft.message.find("permanent contact"), 0U) << aft.message;
  EXPECT_EQ(aft.work.iterations, 0);
  EXPECT_FALSE(test::solve<FourierLipschitz>(pressed, {}).work.iterations);
}

}  // namespace
}  // namespace signorini::aft_grid_solver_test
