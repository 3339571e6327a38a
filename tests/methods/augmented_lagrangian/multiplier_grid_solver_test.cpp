#include "methods/augmented_lagrangian/multiplier_grid_solver.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::multiplier_grid_solver_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

/// Signorini's condition with rho so many times the highest dynamic stiffness, solved on a fine grid.
GridSolution solve_with(const Problem& problem, int harmonics, double multiple, int updates, Work& work,
                        bool plain = true) {
  const ContactReceptance receptance = fourier_receptance(problem, harmonics);
  const Eigen::VectorXd gap = contact_gaps(problem);
  const ProjectedLaw law{.constant = multiple * highest_dynamic_stiffness(receptance),
                         .multiplier_weight = Eigen::VectorXd::Ones(gap.size())};
  return multiplier_grid_solver({.tolerance = 1e-8}, updates, plain)({receptance, gap, law}, 8 * harmonics,
                                                                     {}, {}, work);
}

int updates_told(const GridSolution& solution) {
  int updates = -1;
  std::sscanf(solution.message.c_str(), "solved after %d updates", &updates);
  return updates;
}

// Updates counted by an independent implementation, with sampling and error measure of its own.
TEST(MultiplierGridSolver, TakesTheUpdatesThatTheRateAsksFor) {
  struct Row {
    int harmonics;
    double multiple;
    int updates;
  };
  const Problem problem = test::to_problem(kStop);
  for (const Row& row :
       {Row{10, 4.0, 13}, Row{10, 16.0, 7}, Row{10, 64.0, 4}, Row{20, 4.0, 20}, Row{20, 16.0, 9}}) {
    Work work;
    const GridSolution solution = solve_with(problem, row.harmonics, row.multiple, 150, work);
    ASSERT_TRUE(solution.solved) << solution.message;
    EXPECT_NEAR(updates_told(solution), row.updates, 3) << row.harmonics << ", " << row.multiple;
  }
}

// C is not monotone: the same equations are solved by Newton's method, and the multiplier runs away from
// there.
TEST(MultiplierGridSolver, TellsThatTheMultiplierRunsAway) {
  const Problem problem = load_scene(find_scene("chain2-stop"));
  Work work;
  constexpr double kMultiple = 4.0;  // below, the acceleration fails or not by rounding
  const GridSolution solution = solve_with(problem, 40, kMultiple, 150, work);
  EXPECT_FALSE(solution.solved);
  int updates = 0;
  double factor = 0.0;
  ASSERT_EQ(
      std::sscanf(solution.message.c_str(),
                  "Newton's method does not follow after %d updates of the multiplier, residual times %lf",
                  &updates, &factor),
      2)
      << solution.message;
  EXPECT_GT(factor, 1.0);
  EXPECT_TRUE(solve_with(problem, 40, kMultiple, 150, work, false).solved);  // accelerated
  const ContactReceptance receptance = fourier_receptance(problem, 40);
  const auto constant = highest_dynamic_stiffness(receptance)[0] / contact_stiffness_scale(problem)[0];
  const auto newton = FourierLipschitz({.common = {.harmonics = 40}, .c = constant});
  EXPECT_EQ(newton.prepare(problem)->solve({}).verdict, Verdict::converged);
}

TEST(MultiplierGridSolver, EndsAtItsLimits) {
  const Problem problem = test::to_problem(kStop);
  Work work;
  const GridSolution few = solve_with(problem, 10, 4.0, 2, work);
  EXPECT_FALSE(few.solved);
  EXPECT_NE(few.message.find("not converged after 2 updates"), std::string::npos) << few.message;
}

// A force that pulls is no multiplier that Newton's method could begin with.
TEST(MultiplierGridSolver, GoesOnThroughSoftPenaltiesFromAForceThatIsFarAway) {
  const Problem problem = test::to_problem(kStop);
  const ContactReceptance receptance = fourier_receptance(problem, 20);
  const Eigen::VectorXd gap = contact_gaps(problem);
  const ProjectedLaw law{.constant = 32.0 * highest_dynamic_stiffness(receptance),
                         .multiplier_weight = Eigen::VectorXd::Ones(1)};
  const auto solve = [&](const Eigen::MatrixXcd& previous, int limit, bool plain) {
    Work work;
    return multiplier_grid_solver({.tolerance = 1e-8, .max_iterations = limit}, 150, plain)(
        {receptance, gap, law}, 160, previous, {}, work);
  };
  const GridSolution cold = solve({}, 0, false);
  ASSERT_TRUE(cold.solved) << cold.message;
  const Eigen::MatrixXcd far = -cold.lambda;
  const GridSolution risen = solve(far, 0, false);
  ASSERT_TRUE(risen.solved) << risen.message;
  EXPECT_NE(risen.message.find("from soft penalties"), std::string::npos) << risen.message;
  EXPECT_LE((risen.lambda - cold.lambda).norm(), 1e-6 * cold.lambda.norm());
  for (const GridSolution& other : {solve(far, 1, false), solve(far, 0, true)})
    EXPECT_EQ(other.message.find("soft"), std::string::npos) << other.message;
}

}  // namespace
}  // namespace signorini::multiplier_grid_solver_test
