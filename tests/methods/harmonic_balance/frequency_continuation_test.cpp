#include "methods/harmonic_balance/frequency_continuation.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::frequency_continuation_test {
namespace {

using test::relative_distance;
using test::solve;

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

HarmonicOptions plain(int harmonics, Continuation continuation) {
  return {.harmonics = harmonics, .continuation = continuation, .plain = true};
}

/// |x_f| of m = k = F = 1, in closed form.
double amplitude(double damping, double frequency) {
  return 1.0 / std::hypot(1.0 - frequency * frequency, damping * frequency);
}

TEST(ContactFreeFrequencies, AreTheNearestOfTheSearchOnBothSides) {
  // Static deflection 1, gap 1.5: contact-free below and above the resonance.
  const test::ImpactOscillator resonant{.damping = 0.1, .frequency = 1.0, .gap = 1.5};
  const std::vector<double> found = contact_free_frequencies(test::to_problem(resonant), 320, {});
  ASSERT_EQ(found.size(), 2U);
  for (const double frequency : found) {
    EXPECT_LT(amplitude(0.1, frequency), 1.5);
    EXPECT_GE(amplitude(0.1, frequency > 1.0 ? frequency / 1.1 : frequency * 1.1), 1.5);
    const double steps = std::log(frequency) / std::log(1.1);
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
  }
  EXPECT_LE(std::abs(std::log(found[0])), std::abs(std::log(found[1]))) << "the nearer one first";
}

TEST(ContactFreeFrequencies, AreOnlyAboveWhereTheStaticDeflectionTouches) {
  const std::vector<double> found = contact_free_frequencies(test::to_problem(kStop), 320, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0], 2.2 * 1.1 * 1.1, 1e-12);
}

TEST(ContactFreeFrequencies, AreTheScenesOwnWhereNothingTouches) {
  const std::vector<double> found =
      contact_free_frequencies(test::to_problem({.frequency = 2.2, .gap = 3.0}), 320, {});
  EXPECT_EQ(found, std::vector<double>{2.2});
}

TEST(ContactFreeFrequencies, AreMissingWithAPreloadAndWithoutAGap) {
  for (const double gap : {-0.3, 0.0}) {
    const Problem problem = test::to_problem({.frequency = 2.2, .gap = gap});
    EXPECT_TRUE(contact_free_frequencies(problem, 320, {}).empty()) << gap;
  }
}

TEST(ContactFreeFrequencies, SkipAResonanceWithoutDamping) {
  // Twenty steps below w the load meets the resonance, to rounding.
  const double frequency = std::pow(1.1, 20);
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = frequency, .gap = 0.01});
  EXPECT_NO_THROW((void)contact_free_frequencies(problem, 320, {}));
}

class FrequencyContinuation : public testing::TestWithParam<int> {};

TEST_P(FrequencyContinuation, LeadsToASolutionOfThePlainEquationsThatPivotingFinds) {
  const Problem problem = test::to_problem(kStop);
  const HarmonicOptions followed = plain(GetParam(), Continuation::frequency);
  const HarmonicOptions cold = plain(GetParam(), Continuation::none);
  const Solution lipschitz = solve<FourierLipschitz>(problem, {.common = followed});
  ASSERT_EQ(lipschitz.verdict, Verdict::converged) << lipschitz.message;
  EXPECT_NE(lipschitz.message.find("steps in frequency from 2.662 rad/s"), std::string::npos)
      << lipschitz.message;
  EXPECT_FALSE(lipschitz.work.pivots.has_value());
  EXPECT_GT(lipschitz.work.iterations.value(), 0);
  EXPECT_GT(lipschitz.trajectory->force_coefficients().norm(), 0.0);
  const Solution pivoted =
      solve<FourierLipschitz>(problem, {.common = cold, .c = 1.0, .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  EXPECT_LE(relative_distance(*pivoted.trajectory, *lipschitz.trajectory), 1e-8);
}

TEST_P(FrequencyContinuation, IsTheSameForTheSameEquations) {
  const Problem problem = test::to_problem(kStop);
  const HarmonicOptions followed = plain(GetParam(), Continuation::frequency);
  const Solution aft = solve<AftHbm>(problem, {.common = followed});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  const Solution twin = solve<FourierLipschitz>(problem, {.common = followed});
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Harmonics, FrequencyContinuation, testing::Values(10, 20, 40));

TEST(ContinueInFrequency, TakesNoStepWhereNothingTouches) {
  const Problem problem = test::to_problem({.frequency = 2.2, .gap = 3.0});
  const Solution solution = solve<FourierLipschitz>(problem, {.common = plain(10, Continuation::frequency)});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.message.find("0 steps in frequency"), 0U) << solution.message;
  EXPECT_EQ(solution.work.iterations, 0);
  EXPECT_EQ(solution.trajectory->force_coefficients().norm(), 0.0);
}

TEST(ContinueInFrequency, SaysWhereItHasNothingToStartFrom) {
  const Problem preloaded = test::to_problem({.frequency = 0.6, .gap = -0.3});
  const Solution solution = solve<PenaltyHbm>(preloaded, {.common = plain(10, Continuation::frequency)});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.trajectory, nullptr);
  EXPECT_EQ(
      solution.message,
      "continuation in frequency: no frequency found from 0.0284 to 12.7 rad/s at which nothing touches");
}

TEST(ContinueInFrequency, SaysHowFarItCame) {
  // Two Newton steps in all do not go far.
  HarmonicOptions options = plain(20, Continuation::frequency);
  options.max_iterations = 2;
  const Solution solution = solve<FourierLipschitz>(test::to_problem(kStop), {.common = options});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.message.find("continuation in frequency: from 2.662 to "), 0U) << solution.message;
  EXPECT_LE(solution.work.iterations.value(), 2);
}

TEST(ContinueInFrequency, EndsWithItsTimeBudget) {
  const Problem problem = test::to_problem(kStop);
  const Start late{.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)};
  const Solution solution =
      FourierLipschitz({.common = plain(20, Continuation::frequency)}).prepare(problem)->solve(late);
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.work.iterations.value_or(0), 0);
}

TEST(ContinueInFrequency, IsLeftOutWhereThereIsAGuess) {
  const Problem problem = test::to_problem(kStop);
  const FourierLipschitz::Options options{.common = plain(20, Continuation::frequency)};
  const Solution cold = solve<FourierLipschitz>(problem, options);
  ASSERT_EQ(cold.verdict, Verdict::converged) << cold.message;
  const Solution warm = solve<FourierLipschitz>(problem, options, cold.trajectory);
  EXPECT_EQ(warm.verdict, Verdict::converged) << warm.message;
  EXPECT_EQ(warm.message.find("steps in frequency"), std::string::npos) << warm.message;
  EXPECT_LE(warm.work.iterations.value(), 5);
}

}  // namespace
}  // namespace signorini::frequency_continuation_test
