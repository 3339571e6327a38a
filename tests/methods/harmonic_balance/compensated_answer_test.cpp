#include "methods/harmonic_balance/compensated_answer.hpp"

#include <gtest/gtest.h>

#include <string>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/population.hpp"

namespace signorini {
namespace {

constexpr auto kNone = ClosedRestitution::none;  // compensation alone

/// A scene with ten harmonics and its series, impacts as they come.
struct Solved {
  explicit Solved(const test::ImpactOscillator& oscillator)
      : problem(test::to_problem(oscillator)),
        setup(harmonic_setup(
            problem, 10, {.harmonics = 10, .restitution = kNone},
            {.law_at = [this](const ContactReceptance& level) { return lipschitz_law(problem, {}, level); },
             .grid_solver = lcp_grid_solver({})})) {
    Work work;
    series = solve_on_grids(setup, {}, work);
    EXPECT_EQ(series.verdict, Verdict::converged) << series.message;
  }

  Problem problem;
  HarmonicSetup setup;
  Solution series;
};

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

bool says(const Solution& solution, const std::string& words) {
  return solution.message.find(words) != std::string::npos;
}

TEST(CompensatedSeries, IsNearerToTheOrbitThanTheSeries) {
  const Solved solved(kStop);
  Work work;
  const CompensatedSeries compensated = compensate_series(solved.setup, solved.series, {}, work);
  ASSERT_TRUE(compensated.answer);
  EXPECT_TRUE(compensated.exact);
  EXPECT_TRUE(says(*compensated.answer, "1 impact compensated")) << compensated.answer->message;
  EXPECT_GT(work.iterations.value(), 0);
  const auto orbit = test::single_impact_orbits(kStop).front();
  const auto error = [&](const Solution& solution) {
    return test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); });
  };
  EXPECT_LT(8.0 * error(*compensated.answer), error(solved.series));
  EXPECT_EQ(stop_shifts(*compensated.answer->trajectory).size(), 1U);
}

TEST(CompensatedSeries, IsTheSeriesItselfWhereNothingIsAnImpact) {
  const Solved solved({.damping = 0.1, .frequency = 0.6, .gap = -1.5});
  Work work;
  const CompensatedSeries compensated = compensate_series(solved.setup, solved.series, {}, work);
  ASSERT_TRUE(compensated.answer);
  EXPECT_EQ(compensated.answer->message, solved.series.message);
  EXPECT_EQ(compensated.answer->trajectory, solved.series.trajectory);
}

TEST(CompensatedSeries, KeepsWithinALimit) {
  Solved solved(kStop);
  solved.setup.options.max_iterations = 1;
  Work work{.pivots = 1};
  const CompensatedSeries compensated = compensate_series(solved.setup, solved.series, {}, work);
  EXPECT_FALSE(compensated.answer);
  EXPECT_TRUE(compensated.exact);
  EXPECT_FALSE(work.iterations);
}

TEST(CompensatedFromGuess, TakesUpACompensatedAnswerAlone) {
  const Solved solved(kStop);
  Work work;
  const CompensatedSeries compensated = compensate_series(solved.setup, solved.series, {}, work);
  ASSERT_TRUE(compensated.answer);
  Work again;
  const Start start{.guess = compensated.answer->trajectory};
  const std::optional<Solution> warm = compensated_from_guess(solved.setup, start, again);
  ASSERT_TRUE(warm);
  EXPECT_TRUE(says(*warm, "Newton from the guess"));
  EXPECT_LE(again.iterations.value(), 1);
  EXPECT_LE(test::relative_distance(*warm->trajectory, *compensated.answer->trajectory), 1e-9);
  EXPECT_FALSE(compensated_from_guess(solved.setup, {.guess = solved.series.trajectory}, again));
  EXPECT_FALSE(compensated_from_guess(solved.setup, {}, again));
}

TEST(CompensatedFromMotion, LeadsFromANearbyMotionToTheAnswer) {
  const Solved solved(kStop);
  Work work;
  const std::optional<Solution> found =
      compensated_from_motion(solved.setup, *solved.series.trajectory, "from the series", {}, work);
  ASSERT_TRUE(found);
  EXPECT_TRUE(says(*found, "from the series; 1 impact compensated")) << found->message;
}

using test::relative_distance;
using test::solve;

Problem hard_scene(int index) { return test::to_problem(test::hard_population(index + 1).back()); }

/// Relative distance of an answer from the exact orbit that it leads to.
double error_of(const Problem& problem, const Solution& solution) {
  const Solution exact = solve<ExactOrbitMethod>(problem, {}, solution.trajectory);
  EXPECT_EQ(exact.verdict, Verdict::converged) << exact.message;
  return relative_distance(*solution.trajectory, *exact.trajectory);
}

// Twenty harmonics of this motion rattle: the path of pivots ends at a solution whose impacts cannot be
// compensated.
TEST(HatAgreement, FindsByHatFunctionsWhatFewHarmonicsMiss) {
  const Problem problem = hard_scene(139);
  const Solution alone = solve<FourierLipschitz>(problem, {.common = {.harmonics = 20, .restitution = kNone},
                                                           .solver = ComplementaritySolver::pivoting});
  ASSERT_TRUE(says(alone, "impacts not compensated")) << alone.message;
  const Solution lipschitz = solve<FourierLipschitz>(problem, {{.harmonics = 20, .restitution = kNone}});
  const Solution penalty = solve<PenaltyHbm>(problem, {{.harmonics = 20, .restitution = kNone}});
  const Solution aft = solve<AftHbm>(problem, {{.harmonics = 20, .restitution = kNone}});
  for (const Solution* solution : {&lipschitz, &penalty, &aft}) {
    ASSERT_EQ(solution->verdict, Verdict::converged) << solution->message;
    EXPECT_TRUE(says(*solution, "hat functions first")) << solution->message;
    EXPECT_LE(error_of(problem, *solution), 0.02);
  }
}

// The same by AFT with Newton alone, for which hat functions would be another homotopy.
TEST(HatAgreement, LeavesNewtonAlone) {
  const Solution newton =
      solve<AftHbm>(hard_scene(139), {.common = {.harmonics = 20, .restitution = kNone}, .homotopy = false});
  EXPECT_FALSE(says(newton, "hat functions")) << newton.message;
}

TEST(HatAgreement, DoesNotClaimWhatHatFunctionsContradict) {
  const Problem problem = hard_scene(414);
  const Solution few = solve<FourierLipschitz>(problem, {{.harmonics = 20, .restitution = kNone}});
  EXPECT_EQ(few.verdict, Verdict::not_converged);
  EXPECT_TRUE(says(few, "away from the motion on hat functions")) << few.message;
  // Left to the method, more harmonics are tried.
  const Solution more = solve<FourierLipschitz>(problem, {{.restitution = kNone}});
  ASSERT_EQ(more.verdict, Verdict::converged) << more.message;
  EXPECT_TRUE(says(more, "; H = ")) << more.message;
  EXPECT_LE(error_of(problem, more), 0.1);
}

TEST(HatAgreement, IsNotAskedUnderALimitOnIterations) {
  const Solution limited = solve<FourierLipschitz>(
      hard_scene(139), {{.harmonics = 20, .restitution = kNone, .max_iterations = 100000}});
  EXPECT_FALSE(says(limited, "hat functions")) << limited.message;
}

Solution claimed() { return {.verdict = Verdict::converged, .message = "solved"}; }

TEST(ClaimIfBorneOut, KeepsAnExactSeriesThatHatFunctionsAreNear) {
  const Solution kept = claim_if_borne_out(claimed(), true, {.asked = true, .distance = 0.3}, 0.5);
  EXPECT_EQ(kept.verdict, Verdict::converged);
  EXPECT_EQ(kept.message, "solved; impacts not compensated");
}

TEST(ClaimIfBorneOut, KeepsASeriesThatNoGridCarries) {
  EXPECT_EQ(claim_if_borne_out(claimed(), false, {}, 0.1).verdict, Verdict::converged);
}

TEST(ClaimIfBorneOut, WithdrawsEveryOtherClaimAndSaysWhy) {
  const auto expect_withdrawn = [](bool exact, const HatAgreement& agreement, const std::string& message) {
    const Solution withdrawn = claim_if_borne_out(claimed(), exact, agreement, 0.5);
    EXPECT_EQ(withdrawn.verdict, Verdict::not_converged);
    EXPECT_EQ(withdrawn.message, message);
  };
  expect_withdrawn(false, {.asked = true, .distance = 0.3},
                   "solved; impacts not compensated, nor the contact integral exact");
  expect_withdrawn(true, {.asked = true, .distance = 0.75},
                   "solved; impacts not compensated and 0.75 away from the motion on hat functions");
  expect_withdrawn(true, {.asked = true}, "solved; impacts not compensated, nor borne out by hat functions");
}

TEST(ClaimIfBorneOut, SaysNothingOfAnAnswerThatIsNotClaimed) {
  EXPECT_EQ(claim_if_borne_out({.message = "stalled"}, false, {.asked = true}, 0.5).message, "stalled");
}

}  // namespace
}  // namespace signorini
