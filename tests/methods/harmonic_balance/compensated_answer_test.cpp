#include "methods/harmonic_balance/compensated_answer.hpp"

#include <gtest/gtest.h>

#include <string>

#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/lcp_grid_solver.hpp"
#include "methods/harmonic_balance/sample_grids.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// A scene with ten harmonics and its series, impacts as they come.
struct Solved {
  explicit Solved(const test::ImpactOscillator& oscillator)
      : problem(test::to_problem(oscillator)),
        setup(harmonic_setup(
            problem, 10, {.harmonics = 10},
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
  solved.setup.settings.limit = 1;
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

}  // namespace
}  // namespace signorini
