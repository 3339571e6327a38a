#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "methods/periodic_motion/periodic_motion.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/methods/event_driven/scenes.hpp"
#include "tests/methods/periodic_motion/steady_state_cases.hpp"

namespace signorini::steady_state_test {
namespace {

using test::ImpactOscillator;
using test::solve;
using test::steady_state_case;
using test::to_problem;

TEST(Marching, FindsThePeriodDoubledMotionWithItsAlternatingImpacts) {
  const ImpactOscillator o{.damping = 0.05, .frequency = 2.7, .gap = 0.0, .restitution = 0.7};
  const Solution solution = solve(to_problem(o), {.tolerance = 1e-10});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const double forcing_period = 2.0 * std::numbers::pi / 2.7;
  EXPECT_NEAR(solution.trajectory->period(), 2.0 * forcing_period, 1e-12);
  const auto events = test::events_of(solution);
  ASSERT_EQ(events.size(), 2U);
  const double first = test::approach_speed(events[0], o.restitution);
  const double second = test::approach_speed(events[1], o.restitution);
  EXPECT_NEAR(std::max(first, second), 0.48353373, 1e-8);
  EXPECT_NEAR(std::min(first, second), 0.45266174, 1e-8);
  const double interval = (events[1].time - events[0].time) / forcing_period;
  EXPECT_NEAR(std::abs(interval - 1.0), 0.149225, 1e-6);
}

TEST(Marching, FindsASubharmonicOfOrderTwoBesideTheUnstableHarmonicMotion) {
  const ImpactOscillator o{.damping = 0.02, .frequency = 4.1, .gap = 0.01, .restitution = 0.8, .order = 2};
  const auto orbit = test::single_impact_orbits(o).at(0);
  for (const int wanted : {1, 2}) {
    Problem problem = to_problem(o);
    problem.subharmonic = wanted;
    const Solution solution = solve(problem, {.tolerance = 1e-10});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_NEAR(solution.trajectory->period(), orbit.period, 1e-12);
    EXPECT_LT(test::distance(*solution.trajectory, orbit), 1e-8);
  }
}

TEST(Marching, ReportsTheForcingPeriodWhereASubharmonicWasLookedForInVain) {
  Problem problem = to_problem({.frequency = 2.2, .gap = 0.2, .restitution = 0.8});
  problem.subharmonic = 3;
  const Solution solution = solve(problem, {.tolerance = 1e-9});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NEAR(solution.trajectory->period(), 2.0 * std::numbers::pi / 2.2, 1e-12);
}

// Chaotic, or of an order above the 8 looked for: an honest end, no false subharmonic, at any tolerance.
class NotPeriodic : public testing::TestWithParam<double> {};

void expect_not_periodic(const Problem& problem, double tolerance) {
  const Solution solution = solve(problem, {.tolerance = tolerance, .max_iterations = 600});
  EXPECT_EQ(solution.verdict, Verdict::not_converged) << solution.message;
  EXPECT_NE(solution.message.find("not periodic after 600 periods"), std::string::npos) << solution.message;
  ASSERT_TRUE(solution.trajectory);
  EXPECT_TRUE(solution.trajectory->sample(16).x.allFinite());
  EXPECT_GT(solution.residual.value_or(0.0), 1e-4);
}

TEST_P(NotPeriodic, OneMassWithoutGapAtFrequencyThreeFifths) {
  expect_not_periodic(to_problem({.frequency = 0.6, .gap = 0.0, .restitution = 0.9}), GetParam());
}

TEST_P(NotPeriodic, OneMassNearGrazingOfOrderEighteen) {
  expect_not_periodic(to_problem({.frequency = 2.5, .gap = 0.2, .restitution = 0.5}), GetParam());
}

TEST_P(NotPeriodic, OneLightlyDampedMassNearGrazingOfOrderFortyTwo) {
  expect_not_periodic(to_problem({.damping = 0.02, .frequency = 2.5, .gap = 0.2, .restitution = 0.5}),
                      GetParam());
}

TEST_P(NotPeriodic, TwoMassesWithOneStop) {
  Problem problem = steady_state_case("chain", "chainA_w1.5_e0.9").problem;
  problem.set_law(Restitution{0.5});
  expect_not_periodic(problem, GetParam());
}

TEST_P(NotPeriodic, TwoMassesWithTwoStopsOfOrderEighteen) {
  Problem problem = steady_state_case("chain", "chainB_w2_e0.9").problem;
  problem.set_law(Restitution{0.5});
  expect_not_periodic(problem, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Tolerances, NotPeriodic, testing::Values(1e-6, 1e-9, 1e-11));

TEST(Marching, FindsOrderFourAndSixBetweenTwoSidedStops) {
  Problem problem = steady_state_case("chain", "chainA_w1.5_e0.9").problem;
  problem.contacts.push_back({.normal = {{1, -1.0}}, .gap = 0.5});
  for (const auto& [e, order] : {std::pair{0.5, 4}, std::pair{0.9, 6}}) {
    problem.set_law(Restitution{e});
    const Solution solution = solve(problem, {.tolerance = 1e-9});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_NEAR(solution.trajectory->period() * problem.frequency / (2.0 * std::numbers::pi), order, 1e-9);
  }
}

// The free motion turns by a third in each period of the load, so that the motion from rest first repeats
// nearly after three; the periodic one is of order one, and its multiplier that of one period.
TEST(Marching, GivesTheMultiplierOfTheMotionsOwnOrder) {
  const ImpactOscillator o{.damping = 0.1, .frequency = 3.0, .gap = 50.0, .restitution = 0.9};
  for (const Integrator flow : {Integrator::modal, Integrator::cvode}) {
    const Solution solution = solve(to_problem(o), {.tolerance = 1e-9, .flow = flow});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const double period = 2.0 * std::numbers::pi / o.frequency;
    EXPECT_NEAR(solution.trajectory->period(), period, 1e-12);
    const std::size_t place = solution.message.find("largest multiplier ");
    ASSERT_NE(place, std::string::npos) << solution.message;
    const double multiplier = std::stod(solution.message.substr(place + std::strlen("largest multiplier ")));
    EXPECT_NEAR(multiplier, std::exp(-0.5 * o.damping * period), 1e-5) << solution.message;
  }
}

TEST(Marching, DetectsOnlyTheOrdersAskedFor) {
  const ImpactOscillator o{
      .damping = 0.05, .frequency = 2.7, .gap = 0.0, .restitution = 0.7};  // of order two
  const Solution solution = solve(to_problem(o), {.tolerance = 1e-9, .max_iterations = 300, .max_order = 1});
  EXPECT_EQ(solution.verdict, Verdict::not_converged) << solution.message;
}

TEST(Marching, IsNotFooledBySlowConvergence) {
  // Contact-free, damping ratio 1.5e-3: 1 % a period. Long before it has settled, a period changes little.
  const ImpactOscillator o{.damping = 0.003, .frequency = 2.2, .gap = 5.0, .restitution = 1.0};
  const Solution solution = solve(to_problem(o), {.tolerance = 1e-10});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const double amplitude = 1.0 / std::hypot(1.0 - 2.2 * 2.2, 0.003 * 2.2);
  EXPECT_NEAR(solution.trajectory->sample(64).x.maxCoeff(), amplitude, 1e-3 * amplitude);
  const double phase = std::atan2(-0.003 * 2.2, 1.0 - 2.2 * 2.2);
  EXPECT_NEAR(solution.trajectory->sample(1).x(0, 0), amplitude * std::cos(phase), 1e-9 * amplitude);
}

TEST(Marching, StaysOnAnOrbitGivenAsGuess) {
  const ImpactOscillator o{.frequency = 1.0, .gap = 1.0, .restitution = 0.8};
  const Problem problem = to_problem(o);
  const Solution first = solve(problem, {.tolerance = 1e-10});
  ASSERT_EQ(first.verdict, Verdict::converged);
  const Solution again = solve(problem, {.tolerance = 1e-10}, first.trajectory);
  ASSERT_EQ(again.verdict, Verdict::converged) << again.message;
  EXPECT_LE(again.work.iterations.value_or(1000), first.work.iterations.value_or(0));
  EXPECT_LT(test::distance(*again.trajectory, test::single_impact_orbits(o).at(0)), 1e-8);
}

TEST(Shooting, FindsTheUnstableHarmonicMotionBesideAStableSubharmonic) {
  const ImpactOscillator o{.damping = 0.02, .frequency = 4.1, .gap = 0.01, .restitution = 0.8};
  const auto orbit = test::single_impact_orbits(o).at(0);
  ASSERT_FALSE(orbit.stable());
  const Problem problem = to_problem(o);
  const auto guess = test::guess_from(problem, Eigen::VectorXd::Constant(1, orbit.x(0.0) * 1.002),
                                      Eigen::VectorXd::Constant(1, orbit.velocity(0.0)));
  const Solution solution =
      solve(problem, {.tolerance = 1e-10, .steady = EventDriven::Steady::shooting}, guess);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_LT(test::distance(*solution.trajectory, orbit), 1e-8);
}

TEST(Shooting, SaysWhyItFails) {
  // No orbit of this kind exists: the linear response stays clear, the guess hits hard.
  const ImpactOscillator o{.frequency = 0.6, .gap = 0.0, .restitution = 0.9};
  const Solution solution =
      solve(to_problem(o), {.tolerance = 1e-9, .steady = EventDriven::Steady::shooting, .max_iterations = 1});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_NE(solution.message.find("no periodic motion after 1 Newton step"), std::string::npos)
      << solution.message;
  EXPECT_EQ(solution.work.iterations, 1);
}

// The monodromy at a fixed point against the closed form: trace and determinant.
TEST(NewtonOrbit, MultipliersAreThoseOfTheClosedForm) {
  for (const ImpactOscillator& o :
       {ImpactOscillator{.frequency = 2.2, .gap = 0.2, .restitution = 1.0},
        ImpactOscillator{.frequency = 1.0, .gap = 1.0, .restitution = 0.8},
        ImpactOscillator{.damping = 0.0, .frequency = 2.0001, .gap = 0.001, .restitution = 0.4}}) {
    const auto orbit = test::single_impact_orbits(o).at(0);
    const ContactDynamics dynamics(to_problem(o));
    EventFlow flow(dynamics, 1e-11, [] { return false; });
    PeriodMap map(flow);
    const double quiet = std::fmod(orbit.impact_time + 0.5 * orbit.period, orbit.period);
    const FlowState guess = flow.place(quiet, {.u = Eigen::VectorXd::Constant(1, orbit.x(quiet)),
                                               .v = Eigen::VectorXd::Constant(1, orbit.velocity(quiet))});
    const FixedPoint found = find_fixed_point(map, guess, 1, {.accepted = 1e-10}, [] { return false; });
    ASSERT_TRUE(found.converged) << found.message;
    EXPECT_NEAR(found.monodromy.trace(), orbit.trace, 1e-8);
    EXPECT_NEAR(determinant(found.monodromy), orbit.determinant, 1e-9);
  }
}

TEST(MoveToQuietPhase, KeepsClearOfTheEvents) {
  const ContactDynamics dynamics(to_problem({.frequency = 1.0, .gap = 5.0}));
  EventFlow flow(dynamics, 1e-9, [] { return false; });
  PeriodMap map(flow);
  FlowState state = flow.place(0.0, {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)});
  const double period = map.forcing_period();
  move_to_quiet_phase(map, state, {{.time = 0.0}, {.time = 0.3 * period}, {.time = 1.9 * period}});
  EXPECT_NEAR(state.time / period, 0.6, 0.02);  // the middle of (0.3, 0.9)
}

}  // namespace
}  // namespace signorini::steady_state_test
