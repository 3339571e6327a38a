#include "methods/aft_hbm/aft_hbm.hpp"

#include <gtest/gtest.h>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::aft_hbm_test {
namespace {

using test::relative_distance;
using test::solve;

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

class AftEqualsItsTwin : public testing::TestWithParam<int> {};

TEST_P(AftEqualsItsTwin, DynamicLagrangiansAreFourierLipschitz) {
  const int harmonics = GetParam();
  const int samples = 32 * harmonics;
  const Problem problem = test::to_problem(kStop);
  const Solution aft = solve<AftHbm>(
      problem,
      {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled}, .c = 10.0});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  const Solution twin = solve<FourierLipschitz>(
      problem,
      {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled}, .c = 10.0});
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

TEST_P(AftEqualsItsTwin, ThePenaltyLawIsPenaltyHbm) {
  const int harmonics = GetParam();
  const int samples = 32 * harmonics;
  const Problem problem = test::to_problem(kStop);
  const Scaled penalty{300.0, false};
  const Solution aft = solve<AftHbm>(
      problem, {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled},
                .law = AftHbm::ContactLaw::penalty,
                .penalty = penalty});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  const Solution twin = solve<PenaltyHbm>(
      problem, {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled},
                .penalty = penalty});
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

TEST_P(AftEqualsItsTwin, AlsoWithTheExactContactIntegral) {
  const Problem problem = test::to_problem(kStop);
  const Solution aft = solve<AftHbm>(problem, {{.harmonics = GetParam()}});
  const Solution twin = solve<FourierLipschitz>(problem, {{.harmonics = GetParam()}});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Harmonics, AftEqualsItsTwin, testing::Values(3, 10, 25));

TEST(AftHbm, NewtonAloneIsWhatTheHomotopyRepairs) {
  const Problem problem = test::to_problem(kStop);
  const Solution alone =
      solve<AftHbm>(problem, {.common = {.harmonics = 20, .samples = 640}, .homotopy = false});
  EXPECT_EQ(alone.verdict, Verdict::not_converged);
  EXPECT_GT(alone.residual.value(), 1e-10);
  const Solution repaired = solve<AftHbm>(problem, {{.harmonics = 20, .samples = 640}});
  EXPECT_EQ(repaired.verdict, Verdict::converged) << repaired.message;
}

// Cold, its own iteration is what runs.
TEST(AftHbm, AlternatesBetweenFrequencyAndTime) {
  const Solution solution = solve<AftHbm>(test::to_problem(kStop), {{.harmonics = 20}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("Newton-Krylov"), std::string::npos) << solution.message;
}

TEST(AftHbm, NeedsAtMostTwoStepsFromTheAnswer) {
  const Problem problem = test::to_problem(kStop);
  const Solution cold =
      solve<AftHbm>(problem, {{.harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled}});
  const AftHbm::Options newton{.common = {.harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled},
                               .homotopy = false};
  const Solution warm = solve<AftHbm>(problem, newton, cold.trajectory);
  ASSERT_EQ(warm.verdict, Verdict::converged) << warm.message;
  EXPECT_LE(warm.work.iterations.value(), 2);
}

TEST(AftHbm, StopsAtItsIterationLimit) {
  const Solution solution =
      solve<AftHbm>(test::to_problem(kStop), {{.harmonics = 10, .samples = 320, .max_iterations = 5}});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_LE(solution.work.iterations.value() + solution.work.pivots.value_or(0), 5);
}

TEST(AftHbm, RefusesOptionsThatContradictItsLaw) {
  EXPECT_THROW(AftHbm({.penalty = Scaled{1.0, true}}), InvalidOption);
  EXPECT_THROW(AftHbm({.law = AftHbm::ContactLaw::penalty, .c = 1.0}), InvalidOption);
  EXPECT_THROW(AftHbm({{.harmonics = 10, .samples = 15}}), InvalidOption);
}

TEST(AftHbm, TakesNoStepWhereNothingTouches) {
  const Solution solution =
      solve<AftHbm>(test::to_problem({.frequency = 2.2, .gap = 3.0}), {{.harmonics = 3}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.work.iterations.value(), 0);
  EXPECT_FALSE(solution.work.pivots.has_value());
  EXPECT_EQ(solution.trajectory->force_coefficients().norm(), 0.0);
}

TEST(AftHbm, SeparatesTheTiesOfTwoSymmetricStops) {
  Problem problem = test::to_problem({.damping = 0.05, .frequency = 1.2, .gap = 0.3, .restitution = 1.0});
  Contact other = problem.contacts.front();
  for (auto& [dof, coefficient] : other.normal) coefficient = -coefficient;
  problem.contacts.push_back(other);
  const Solution solution = solve<AftHbm>(problem, {{.harmonics = 12}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Solution twin = solve<FourierLipschitz>(problem, {{.harmonics = 12}});
  ASSERT_EQ(twin.verdict, Verdict::converged) << twin.message;
  EXPECT_LE(relative_distance(*twin.trajectory, *solution.trajectory), 1e-7);
}

TEST(AftHbm, ReportsARayAndLeavesFiniteNumbers) {
  // Light damping and few samples break the energy balance that excludes rays.
  const Problem problem =
      test::to_problem({.damping = 0.003, .frequency = 1.6, .gap = 0.5, .restitution = 1.0});
  int rays = 0;
  for (const int samples : {24, 32, 48, 64, 96, 128}) {
    const Solution solution =
        solve<AftHbm>(problem, {{.harmonics = 10, .samples = samples, .quadrature = Quadrature::sampled}});
    rays += solution.message.find("ray") != std::string::npos ? 1 : 0;
    ASSERT_NE(solution.trajectory, nullptr) << samples;
    EXPECT_TRUE(solution.trajectory->sample(16).x.allFinite()) << samples;
  }
  EXPECT_GE(rays, 1);
}

}  // namespace
}  // namespace signorini::aft_hbm_test
