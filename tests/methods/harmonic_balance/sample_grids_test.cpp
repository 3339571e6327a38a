#include "methods/harmonic_balance/sample_grids.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

TEST(SampleLadder, BeginsCoarseWhereTheExactIntegralFollows) {
  EXPECT_EQ(SampleLadder(20, {}, Quadrature::exact).samples(), 8 * 20);
  EXPECT_EQ(SampleLadder(3, {}, Quadrature::exact).samples(), 64);
  EXPECT_EQ(SampleLadder(20, {}, Quadrature::sampled).samples(), 32 * 20);
  EXPECT_EQ(SampleLadder(20, 777, Quadrature::sampled).samples(), 777);
}

TEST(SampleLadder, DoublesUpTo128SamplesPerHarmonicUntilItConverges) {
  SampleLadder ladder(20, {}, Quadrature::exact);
  std::vector<int> samples{ladder.samples()};
  while (ladder.refine(false, false, 1.0)) samples.push_back(ladder.samples());
  EXPECT_EQ(samples, (std::vector<int>{160, 320, 640, 1280, 2560}));
  SampleLadder fixed(20, 640, Quadrature::exact);
  EXPECT_FALSE(fixed.refine(false, false, 1.0));
}

TEST(SampleLadder, StopsAtAnExactIntegralOrAtTheEnergyIdentity) {
  EXPECT_FALSE(SampleLadder(20, {}, Quadrature::exact).refine(true, true, 1.0));
  SampleLadder ladder(20, {}, Quadrature::exact);
  EXPECT_TRUE(ladder.refine(true, false, 1e-6));  // 8 H are too few to trust the identity
  EXPECT_TRUE(ladder.refine(true, false, 1e-6));
  EXPECT_FALSE(ladder.refine(true, false, 1e-6));  // 32 H
  EXPECT_EQ(ladder.samples(), 640);
  EXPECT_TRUE(ladder.refine(true, false, 1e-2));
}

TEST(SampleLadder, AcceptsASampledAnswerThatKeepsTheEnergyIdentity) {
  const SampleLadder exact(20, {}, Quadrature::exact);
  EXPECT_TRUE(exact.accepts(true, 1.0));
  EXPECT_TRUE(exact.accepts(false, 1e-4));
  EXPECT_FALSE(exact.accepts(false, 1e-2));
  EXPECT_TRUE(SampleLadder(20, {}, Quadrature::sampled).accepts(false, 1e-2));
}

/// Solves on a grid from so many samples on, always with the same force; notes what it is asked.
class SolverOnFineGrids final : public GridSolver {
 public:
  SolverOnFineGrids(int finest, bool finer_may_help) : fewest_(finest), finer_may_help_(finer_may_help) {}
  [[nodiscard]] GridSolution solve(const ProjectedEquations& equations, int samples,
                                   const Eigen::MatrixXcd& previous, const Start& /*start*/,
                                   Work& work) const override {
    asked.push_back(samples);
    warm.push_back(previous.size() > 0);
    work.pivots = work.pivots.value_or(0) + 10;
    const auto& receptance = equations.receptance;
    Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
    return {.solved = samples >= fewest_,
            .finer_may_help = finer_may_help_,
            .lambda = lambda,
            .message = "asked"};
  }

  mutable std::vector<int> asked;
  mutable std::vector<bool> warm;

 private:
  int fewest_;
  bool finer_may_help_;
};

HarmonicSetup setup_with(const std::shared_ptr<const GridSolver>& solver) {
  // The gap is so wide that nothing touches: no force solves the equations.
  const Problem problem = test::to_problem({.frequency = 2.2, .gap = 3.0});
  return harmonic_setup(
      problem, 10, {.harmonics = 10, .compensate = false},
      {.law_at =
           [](const ContactReceptance& level) {
             return ProjectedLaw{highest_dynamic_stiffness(level), Eigen::VectorXd::Ones(1)};
           },
       .grid_solver = solver});
}

TEST(SolveOnGrids, RefinesUntilTheSolverConverges) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, true);
  HarmonicSetup setup = setup_with(solver);
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solver->asked, (std::vector<int>{80, 160, 320}));
  EXPECT_EQ(work.pivots, 30);
  EXPECT_EQ(solution.message, "asked; N = 320, net contact work 0.0e+00 of that exchanged");
}

TEST(SolveOnGrids, StopsWhereFinerGridsCannotHelp) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, false);
  HarmonicSetup setup = setup_with(solver);
  Work work;
  EXPECT_EQ(solve_on_grids(setup, {}, work).verdict, Verdict::not_converged);
  EXPECT_EQ(solver->asked, (std::vector<int>{80}));
}

TEST(SolveOnGrids, KeepsWithinItsLimit) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, true);
  HarmonicSetup setup = setup_with(solver);
  setup.settings.limit = 15;
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solver->asked, (std::vector<int>{80, 160}));
  EXPECT_EQ(solution.message.find("pivots or iterations used up"), 0U) << solution.message;
}

}  // namespace
}  // namespace signorini
