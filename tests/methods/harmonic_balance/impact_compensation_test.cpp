// Compensated impacts, judged by closed-form and exact orbits.

#include "methods/harmonic_balance/impact_compensation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini {
namespace {

/// Compensation alone, not the closure that comes before it.
HarmonicOptions compensating(int harmonics) {
  return {.harmonics = harmonics, .restitution = ClosedRestitution::none};
}

using test::ImpactOscillator;
using test::relative_distance;
using test::solve;

// The oscillator "S-A" with restitution 1.
const ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

struct OneImpact {
  std::string name;
  ImpactOscillator oscillator;
};

void PrintTo(const OneImpact& scene, std::ostream* out) { *out << scene.name; }

/// Error against the closed-form orbit that is nearest.
double orbit_error(const ImpactOscillator& oscillator, const Solution& solution) {
  double least = HUGE_VAL;
  for (const auto& orbit : test::single_impact_orbits(oscillator)) {
    least = std::min(least, test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
  }
  return least;
}

bool compensated(const Solution& solution) {
  return solution.message.find(" compensated, stops moved") != std::string::npos;
}

class Compensation : public testing::TestWithParam<OneImpact> {
 protected:
  /// Plain error over default error of a method at so many harmonics, from cold starts. `plain` differs from
  /// the default by the compensation alone, so that both sides are solved as well as can be.
  template <class Method>
  double gain(int harmonics) {
    const Problem problem = test::to_problem(GetParam().oscillator);
    const Solution plain = solve<Method>(problem, {{.harmonics = harmonics, .compensate = false}});
    const Solution found = solve<Method>(problem, {compensating(harmonics)});
    EXPECT_EQ(plain.verdict, Verdict::converged) << plain.message;
    EXPECT_EQ(found.verdict, Verdict::converged) << found.message;
    EXPECT_TRUE(compensated(found)) << found.message;
    return orbit_error(GetParam().oscillator, plain) / orbit_error(GetParam().oscillator, found);
  }
};

TEST_P(Compensation, MakesTheErrorEightTimesSmallerAtEveryOrder) {
  for (const int harmonics : {10, 40, 160}) {
    SCOPED_TRACE(testing::Message() << "H = " << harmonics);
    EXPECT_GE(gain<FourierLipschitz>(harmonics), 8.0);
    EXPECT_GE(gain<PenaltyHbm>(harmonics), 8.0);
    if (harmonics > 40) continue;  // the same solution, at more cost
    EXPECT_GE(gain<AftHbm>(harmonics), 8.0);
  }
}

TEST_P(Compensation, LeavesLittleMoreThanWhatTheSeriesCutsOff) {
  const ImpactOscillator& oscillator = GetParam().oscillator;
  const Solution found = solve<FourierLipschitz>(test::to_problem(oscillator), {compensating(40)});
  ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
  double best = HUGE_VAL;
  for (const auto& orbit : test::single_impact_orbits(oscillator)) {
    double beyond = 0.0, all = std::norm(orbit.fourier(0));
    for (int n = 1; n <= 4000; ++n) {
      all += 2.0 * std::norm(orbit.fourier(n));
      if (n > 40) beyond += 2.0 * std::norm(orbit.fourier(n));
    }
    const double error = test::relative_error(*found.trajectory, [&](double t) { return orbit.x(t); });
    best = std::min(best, error / std::sqrt(beyond / all));
  }
  EXPECT_LE(best, 1.05);
}

INSTANTIATE_TEST_SUITE_P(
    OneImpactPerPeriod, Compensation,
    testing::Values(OneImpact{"AboveResonance", kStop},
                    OneImpact{"LightDamping", {.damping = 0.02, .frequency = 1.8, .gap = 0.1}},
                    OneImpact{"HeavyDamping", {.damping = 0.5, .frequency = 1.3, .gap = 0.3}},
                    OneImpact{"NearResonance", {.damping = 0.1, .frequency = 1.5, .gap = 0.2}},
                    OneImpact{"Resonance", {.damping = 0.1, .frequency = 1.0, .gap = 1.0}},
                    OneImpact{"BelowResonance", {.damping = 0.1, .frequency = 0.5, .gap = 1.0}},
                    OneImpact{"Preload", {.damping = 0.05, .frequency = 2.6, .gap = -0.1}}),
    [](const auto& info) { return info.param.name; });

TEST(Compensated, ImpulseIsTheExactOne) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  const Solution found = solve<FourierLipschitz>(test::to_problem(kStop), {compensating(20)});
  const double impulse = -found.trajectory->force_coefficients()(0, 0).real() * orbit.period;
  EXPECT_NEAR(impulse, orbit.impulse, 1e-4 * orbit.impulse);
}

TEST(Compensated, SolutionsOfTheTwoSolversAreOne) {
  const Problem problem = test::to_problem(kStop);
  const Solution a = solve<FourierLipschitz>(problem, {compensating(20)});
  const Solution b = solve<AftHbm>(problem, {compensating(20)});
  EXPECT_LE(relative_distance(*a.trajectory, *b.trajectory), 1e-8);
}

/// Distance from the exact orbit behind `answer`, with and without compensation, for a multi-impact scene.
void expect_nearer(const Problem& problem, int harmonics, double gain) {
  const Solution plain = solve<FourierLipschitz>(problem, {{.harmonics = harmonics, .compensate = false}});
  const Solution found = solve<FourierLipschitz>(problem, {compensating(harmonics)});
  ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
  ASSERT_TRUE(compensated(found)) << found.message;
  const Solution orbit = solve<ExactOrbitMethod>(problem, {}, found.trajectory);
  ASSERT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
  EXPECT_GE(relative_distance(*orbit.trajectory, *plain.trajectory),
            gain * relative_distance(*orbit.trajectory, *found.trajectory))
      << found.message;
}

TEST(Compensated, EachOfTwoImpactsOnOneStopHasItsOwnShift) {
  const Problem problem = test::to_problem({.damping = 0.207321, .frequency = 1.0777, .gap = -0.277671});
  expect_nearer(problem, 20, 8.0);
  const Solution found = solve<FourierLipschitz>(problem, {compensating(20)});
  const auto& shifts = dynamic_cast<const FourierTrajectory&>(*found.trajectory).data().shifts;
  ASSERT_EQ(shifts.size(), 1U);
  ASSERT_EQ(shifts[0].size(), 2U) << found.message;
  EXPECT_GT(std::abs(shifts[0][0].distance - shifts[0][1].distance), 1e-4);
}

TEST(Compensated, TwoStopsAreShiftedEach) {
  Problem problem = test::to_problem(kStop);
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.25});
  expect_nearer(problem, 20, 4.0);
}

// Twenty harmonics have a motion here with two impacts that solve the equations of impacts, but pass the stop
// by 4 % of the motion between them: no orbit is nearer than the whole motion.
TEST(Compensated, ImpactsOfAMotionThroughTheStopAreNotClaimed) {
  const Problem problem = test::to_problem({.damping = 0.0739778, .frequency = 0.5074165, .gap = 0.7264461});
  EXPECT_NE(solve<FourierLipschitz>(problem, {compensating(20)}).verdict, Verdict::converged);
}

TEST(Compensated, ContactThatLastsIsLeftAlone) {
  const Problem closed = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = -1.5});
  Problem spring = test::to_problem(kStop);
  spring.law = Penalty{{1e4}};
  for (const Problem& problem : {closed, spring, test::massless_node()}) {
    const auto guess = std::make_shared<test::GivenMotion>(
        problem.period(), [](double) { return -1.5; }, [](double) { return -1.5; });
    const auto start = problem.contacts[0].gap < 0.0 ? guess : nullptr;
    const Solution plain = solve<FourierLipschitz>(problem, {{.harmonics = 20, .compensate = false}}, start);
    const Solution found = solve<FourierLipschitz>(problem, {compensating(20)}, start);
    EXPECT_EQ(relative_distance(*plain.trajectory, *found.trajectory), 0.0) << found.message;
    EXPECT_EQ(plain.message, found.message);
  }
}

TEST(Compensated, AMotionThatTouchesNowhereIsLeftAlone) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 3.0});
  EXPECT_FALSE(compensated(solve<FourierLipschitz>(problem, {})));
}

// The stop of the series' own force moves with the compensation: force and lambda belong together.
TEST(Compensated, ForceProjectsToTheCoefficients) {
  const Solution found = solve<FourierLipschitz>(test::to_problem(kStop), {compensating(20)});
  const double mean = found.trajectory->sample(1 << 18).force.col(0).mean();
  const double expected = found.trajectory->force_coefficients()(0, 0).real();
  EXPECT_NEAR(mean, expected, 1e-6 * std::abs(expected));
}

// The figures of the project's tables before compensation (docs/decisions/0011).
TEST(Uncompensated, HasTheErrorsOfTheEquationsAlone) {
  const Problem problem = test::to_problem(kStop);
  const struct {
    int harmonics;
    double lipschitz, penalty;
  } levels[] = {{10, 1.817e-1, 1.879e-1}, {40, 5.507e-2, 5.717e-2}};
  for (const auto& [harmonics, lipschitz, penalty] : levels) {
    const HarmonicOptions common{.harmonics = harmonics, .compensate = false};
    const auto pivoting = ComplementaritySolver::pivoting;
    const Solution exact = solve<FourierLipschitz>(problem, {.common = common, .solver = pivoting});
    EXPECT_NEAR(orbit_error(kStop, exact), lipschitz, 1e-4);
    const Solution spring = solve<PenaltyHbm>(problem, {.common = common, .solver = pivoting});
    EXPECT_NEAR(orbit_error(kStop, spring), penalty, 1e-4);
    // Sampled: the same but for the quadrature.
    HarmonicOptions on_samples = common;
    on_samples.samples = 32 * harmonics;
    on_samples.quadrature = Quadrature::sampled;
    const Solution sampled = solve<FourierLipschitz>(problem, {.common = on_samples, .solver = pivoting});
    EXPECT_NE(sampled.message.find("N = " + std::to_string(32 * harmonics)), std::string::npos);
    EXPECT_NEAR(orbit_error(kStop, sampled), lipschitz, 0.05 * lipschitz);
  }
}

// At equal c and eps the plain form is nothing but the uncompensated equations on 32 H samples.
TEST(Plain, TakesTheLiteraturesConstants) {
  const Problem problem = test::to_problem(kStop);
  const auto pivoting = ComplementaritySolver::pivoting;
  const HarmonicOptions plain{.harmonics = 10, .plain = true};
  const HarmonicOptions sampled{
      .harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled, .compensate = false};
  const Solution lipschitz = solve<FourierLipschitz>(problem, {.common = plain, .solver = pivoting});
  ASSERT_EQ(lipschitz.verdict, Verdict::converged) << lipschitz.message;
  const Solution given = solve<FourierLipschitz>(problem, {.common = sampled, .c = 1.0, .solver = pivoting});
  EXPECT_EQ(relative_distance(*lipschitz.trajectory, *given.trajectory), 0.0);
  const Solution penalty = solve<PenaltyHbm>(problem, {.common = plain, .solver = pivoting});
  ASSERT_EQ(penalty.verdict, Verdict::converged) << penalty.message;
  const Solution stiff =
      solve<PenaltyHbm>(problem, {.common = sampled, .penalty = Scaled{100.0, false}, .solver = pivoting});
  EXPECT_LE(relative_distance(*penalty.trajectory, *stiff.trajectory), 1e-12) << "k = 1";
}

TEST(Plain, SolvesAsTheLiteratureDoes) {
  const Problem problem = test::to_problem(kStop);
  const Solution newton = solve<FourierLipschitz>(problem, {{.harmonics = 10, .plain = true}});
  EXPECT_FALSE(newton.work.pivots.has_value());
  const Solution frequency_time = solve<AftHbm>(problem, {{.harmonics = 10, .plain = true}});
  EXPECT_FALSE(frequency_time.work.pivots.has_value());
  EXPECT_TRUE(std::holds_alternative<Undetermined>(HatLcp({.plain = true}).law(problem)));
  HatLcp::Options options{.samples = 64, .restitution = HatLcp::ImpactLaw::none};
  options.solver = ComplementaritySolver::pivoting;
  const Solution nodal = solve<HatLcp>(problem, options);
  const Solution plain = solve<HatLcp>(problem, {.samples = 64, .plain = true});
  EXPECT_EQ(nodal.work.pivots, plain.work.pivots);
}

}  // namespace
}  // namespace signorini
