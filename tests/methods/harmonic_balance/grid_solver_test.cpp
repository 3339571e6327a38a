#include "methods/harmonic_balance/grid_solver.hpp"

#include <gtest/gtest.h>

#include "methods/complementarity/forms.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::grid_solver_test {
namespace {

TEST(LcpSettings, PlainMakesAutoTheNewtonIteration) {
  const HarmonicOptions plain{.tolerance = 1e-8, .max_iterations = 7, .plain = true};
  const SolverSettings settings = lcp_settings(plain, ComplementaritySolver::automatic);
  EXPECT_EQ(settings.solver, ComplementaritySolver::newton);
  EXPECT_EQ(settings.tolerance, 1e-8);
  EXPECT_EQ(settings.max_iterations, 7);
  EXPECT_EQ(lcp_settings(plain, ComplementaritySolver::pivoting).solver, ComplementaritySolver::pivoting);
  EXPECT_EQ(lcp_settings({}, ComplementaritySolver::automatic).solver, ComplementaritySolver::automatic);
}

TEST(LcpSettings, TheSolverIsOpenUnlessAnOptionSetsIt) {
  EXPECT_TRUE(leaves_solver_open({}, ComplementaritySolver::automatic));
  EXPECT_FALSE(leaves_solver_open({.plain = true}, ComplementaritySolver::automatic));
  EXPECT_FALSE(leaves_solver_open({}, ComplementaritySolver::newton));
}

TEST(ValidateWithSolver, RefusesAContinuationByPivoting) {
  const HarmonicOptions followed{.continuation = Continuation::frequency, .plain = true};
  EXPECT_NO_THROW(validate(followed, ComplementaritySolver::automatic));
  EXPECT_NO_THROW(validate(followed, ComplementaritySolver::newton));
  EXPECT_THROW(validate(followed, ComplementaritySolver::pivoting), InvalidOption);
  EXPECT_THROW(validate({.harmonics = 0}, ComplementaritySolver::automatic), InvalidOption);
}

/// The oscillator "S-A" under the Lipschitz law.
struct Scene {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  ContactReceptance receptance = fourier_receptance(problem, 10);
  Eigen::VectorXd gap = contact_gaps(problem);
  ProjectedLaw law = lipschitz_law(problem, {}, receptance);

  [[nodiscard]] GridSolution solve(const SolverSettings& settings, Work& work) const {
    return lcp_grid_solver(settings)({receptance, gap, law}, 320, {}, {}, work);
  }
};

TEST(LcpGridSolver, PivotsToASolutionOfTheForm) {
  const Scene scene;
  Work work;
  const GridSolution solution = scene.solve({}, work);
  ASSERT_TRUE(solution.solved) << solution.message;
  EXPECT_LE(solution.residual, 1e-10);
  EXPECT_EQ(work.unknowns, 320);
  EXPECT_GT(work.pivots.value(), 0);
  EXPECT_FALSE(work.iterations);
  // The pressure on the samples belongs to this force: -lambda_0 is its mean, and positive.
  EXPECT_LT(solution.lambda(0, 0).real(), 0.0);
  EXPECT_EQ(solution.lambda.rows(), 11);
}

TEST(LcpGridSolver, CountsWhatWasSpentBeforeAgainstItsLimit) {
  const Scene scene;
  Work fresh;
  const GridSolution solved = scene.solve({.solver = ComplementaritySolver::pivoting}, fresh);
  ASSERT_TRUE(solved.solved);
  const int needed = static_cast<int>(*fresh.pivots);
  Work spent{.pivots = 1};
  const GridSolution late =
      scene.solve({.solver = ComplementaritySolver::pivoting, .max_iterations = needed}, spent);
  EXPECT_FALSE(late.solved);
  EXPECT_EQ(late.message, describe(LcpStatus::limit));
  EXPECT_TRUE(late.finer_may_help);
}

TEST(LcpGridSolver, TakesNoNewtonStepFromItsOwnForces) {
  const Scene scene;
  Work work;
  const GridSolution pivoted = scene.solve({}, work);
  ASSERT_TRUE(pivoted.solved);
  const ProjectedEquations equations{scene.receptance, scene.gap, scene.law};
  const SolverSettings newton{.solver = ComplementaritySolver::newton, .tolerance = 1e-9};
  Work again;
  const GridSolution same = lcp_grid_solver(newton)(equations, 320, pivoted.lambda, {}, again);
  EXPECT_TRUE(same.solved) << same.message;
  EXPECT_EQ(again.iterations, 0);
}

TEST(LcpGridSolver, AsksForNoFinerGridWhereNewtonHasLostItsWay) {
  const Scene scene;
  Work work;
  const GridSolution solution =
      scene.solve({.solver = ComplementaritySolver::newton, .max_iterations = 2}, work);
  EXPECT_FALSE(solution.solved);
  EXPECT_FALSE(solution.finer_may_help);
  EXPECT_LE(work.iterations.value(), 2);
  EXPECT_FALSE(work.pivots);
}

}  // namespace
}  // namespace signorini::grid_solver_test
