#include "methods/harmonic_balance/strategy.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/population.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::strategy_test {
namespace {

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

/// Never solves; notes on how many harmonics it was asked.
struct FailingSolver {
  GridSolution operator()(const ProjectedEquations& equations, int /*samples*/,
                          const Eigen::MatrixXcd& /*previous*/, const Start& /*start*/, Work& work) {
    const ContactReceptance& receptance = equations.receptance;
    harmonics.push_back(receptance.harmonics());
    work.pivots = work.pivots.value_or(0) + 1;
    return {.finer_may_help = false,
            .lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts()),
            .message = "failed"};
  }
  std::vector<int> harmonics;
};

HarmonicMethodFor method_of(std::shared_ptr<FailingSolver> solver, bool open) {
  return [solver = std::move(solver), open](const Problem&) -> HarmonicMethod {
    return {.law_at =
                [](const ContactReceptance& level) {
                  return ProjectedLaw{4.0 * highest_dynamic_stiffness(level),
                                      Eigen::VectorXd::Ones(level.contacts())};
                },
            .grid_solver = std::ref(*solver),
            .solver_is_open = open};
  };
}

bool begins(const Solution& solution, const std::string& words) { return solution.message.find(words) == 0; }

TEST(Strategy, DoublesHarmonicsUpTo640WhereNothingConverges) {
  const auto solver = std::make_shared<FailingSolver>();
  const Problem problem = test::to_problem(kStop);
  const Solution solution = prepare_harmonic_balance(problem, {}, method_of(solver, true))->solve({});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  // Beyond 20 harmonics the start of the continuation is asked before the grids of all of them.
  EXPECT_EQ(solver->harmonics, (std::vector<int>{20, 20, 40, 20, 80, 20, 160, 20, 320, 20, 640}));
  EXPECT_EQ(solution.work.pivots, 11);
  EXPECT_NE(solution.message.find("; H = 640"), std::string::npos) << solution.message;
}

// A spring of 4640 N/m, which 20 harmonics are too few for.
TEST(Strategy, GoesOnToMoreHarmonicsUntilTwoAgree) {
  Problem problem = test::to_problem({.damping = 0.1164, .frequency = 1.754, .gap = -0.2484});
  problem.set_law(Penalty{{4640.0}});
  const Solution exact = test::solve<ExactOrbitMethod>(problem, {});
  const Solution open = test::solve<FourierLipschitz>(problem, {});
  ASSERT_EQ(open.verdict, Verdict::converged) << open.message;
  EXPECT_LE(test::relative_distance(*exact.trajectory, *open.trajectory), 0.05);
  const int harmonics = open.trajectory->bandwidth().value();
  EXPECT_NE(open.message.find("; H = " + std::to_string(harmonics)), std::string::npos) << open.message;
  const Solution asked = test::solve<FourierLipschitz>(problem, {{.harmonics = harmonics}});
  EXPECT_EQ(test::relative_distance(*asked.trajectory, *open.trajectory), 0.0);
  const Solution few = test::solve<FourierLipschitz>(problem, {{.harmonics = 20}});
  EXPECT_EQ(few.verdict, Verdict::converged);
  EXPECT_GT(test::relative_distance(*exact.trajectory, *few.trajectory), 0.05);
}

// On a load of 500 oscillations the first number is 640: one more is asked, for one alone confirms nothing.
TEST(Strategy, ConfirmsAnAnswerBeyondItsLastNumberOfHarmonics) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 0.01, .gap = 10.0});
  problem.force = {{.dof = 0, .harmonic = 500, .cos = 1.0, .sin = 0.0}};
  const Solution solution = test::solve<FourierLipschitz>(problem, {});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.trajectory->bandwidth(), 1280);
}

TEST(Strategy, StaysWithTheHarmonicsOfAUserWhoSetsThemOrTheSolver) {
  const Problem problem = test::to_problem(kStop);
  const auto asked = [&](const HarmonicOptions& options, bool open) {
    const auto solver = std::make_shared<FailingSolver>();
    (void)prepare_harmonic_balance(problem, options, method_of(solver, open))->solve({});
    return solver->harmonics;
  };
  EXPECT_EQ(asked({.harmonics = 40}, true), (std::vector<int>{20, 40}));
  EXPECT_EQ(asked({}, false), (std::vector<int>{20}));
  EXPECT_EQ(asked({.max_iterations = 100}, true), (std::vector<int>{20}));
  EXPECT_EQ(asked({.harmonics = 40, .samples = 512}, true), (std::vector<int>{40}));
}

TEST(Strategy, EndsWithItsTimeBudget) {
  const auto solver = std::make_shared<FailingSolver>();
  const Problem problem = test::to_problem(kStop);
  const Start late{.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)};
  (void)prepare_harmonic_balance(problem, {}, method_of(solver, true))->solve(late);
  EXPECT_EQ(solver->harmonics, (std::vector<int>{20}));
}

TEST(Strategy, ThrowsOnlyWhereTheFirstHarmonicsCannotBePrepared) {
  // Undamped, resonant at harmonic 30: the first 20 can be factorised, 40 cannot.
  Problem problem =
      test::to_problem(test::ImpactOscillator{.damping = 0.0, .frequency = 1.0 / 30.0, .gap = 0.2});
  const auto solver = std::make_shared<FailingSolver>();
  const auto prepared = prepare_harmonic_balance(problem, {}, method_of(solver, true));
  const Solution solution = prepared->solve({});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solver->harmonics, (std::vector<int>{20}));
  EXPECT_NE(solution.message.find("singular"), std::string::npos) << solution.message;
  EXPECT_THROW((void)prepare_harmonic_balance(problem, {.harmonics = 40}, method_of(solver, true)),
               std::runtime_error);
}

TEST(Strategy, AsksNoSolverWhereContactIsPermanentOrAbsent) {
  const auto solver = std::make_shared<FailingSolver>();
  const Problem pressed =
      test::to_problem({.damping = 0.1, .frequency = 0.6, .gap = -1.5, .restitution = 1.0});
  const Solution closed = prepare_harmonic_balance(pressed, {}, method_of(solver, true))->solve({});
  EXPECT_EQ(closed.verdict, Verdict::converged) << closed.message;
  EXPECT_TRUE(begins(closed, "permanent contact")) << closed.message;
  Problem free = test::to_problem(kStop);
  free.contacts.clear();
  const Solution linear = prepare_harmonic_balance(free, {}, method_of(solver, true))->solve({});
  EXPECT_TRUE(begins(linear, "no contact in the scene")) << linear.message;
  EXPECT_TRUE(solver->harmonics.empty());
}

TEST(Strategy, TakesAGuessUpByNewtonAtOnce) {
  const Problem problem = test::to_problem(kStop);
  const FourierLipschitz::Options options{{.harmonics = 40}};
  const Solution cold = test::solve<FourierLipschitz>(problem, options);
  EXPECT_TRUE(begins(cold, "20 harmonics first, Newton from there")) << cold.message;
  const Solution warm = test::solve<FourierLipschitz>(problem, options, cold.trajectory);
  ASSERT_EQ(warm.verdict, Verdict::converged) << warm.message;
  EXPECT_TRUE(begins(warm, "Newton from the guess")) << warm.message;
  EXPECT_FALSE(warm.work.pivots.has_value());
  EXPECT_LE(warm.work.iterations.value(), 1);
  EXPECT_LE(test::relative_distance(*cold.trajectory, *warm.trajectory), 1e-12);
}

// Four massless contacts and more begin at a march, whatever the number of harmonics: all end at one motion.
TEST(Strategy, BeginsSeveralContactsAtAMarch) {
  const Problem block = test::padded_block_problem({});
  const FourierLipschitz method({.common = {.harmonics = 90}});
  const Solution marched = method.prepare(block)->solve({});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  EXPECT_TRUE(begins(marched, "Newton from a march")) << marched.message;
  const Solution few = FourierLipschitz({.common = {.harmonics = 80}}).prepare(block)->solve({});
  ASSERT_EQ(few.verdict, Verdict::converged) << few.message;
  EXPECT_TRUE(begins(few, "Newton from a march")) << few.message;
  const Eigen::MatrixXd x = marched.trajectory->sample(1024).x;
  EXPECT_LT((x - few.trajectory->sample(1024).x).norm(), 1e-2 * (x.rowwise() - x.colwise().mean()).norm());
}

}  // namespace
}  // namespace signorini::strategy_test
