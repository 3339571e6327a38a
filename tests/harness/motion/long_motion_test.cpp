#include "harness/motion/long_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "harness/motion/stop_statistics.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/plan/plan.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/periodic_motion/period_map.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::long_motion_test {
namespace {

Problem oscillator(const std::string& rest) {
  return parse_scene("schema = 1\nname = \"one\"\n" + rest, "one");
}

struct Followed {
  LongMotion motion;
  double period;
};

Followed follow(const Problem& problem, const LongMotionOptions& options = {}, State from = {}) {
  const ContactDynamics dynamics(problem);
  const Deadline endless;
  EventFlow flow(
      dynamics, 1e-10, [] { return false; }, Integrator::modal);
  if (from.u.size() == 0) from = dynamics.at_rest();
  return {follow_long_motion(dynamics, flow.place(0.0, from), options, endless), problem.forcing_period()};
}

// Impacts at the origin with e = 0.9: between impacts volumes shrink at the rate c / m, at each by e^2, so
// that the exponents sum to -c / m + 2 log(e) times the impacts per second, whatever the motion.
TEST(LongMotion, ExponentsOfChaosSumToTheContractionOfVolumes) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 0.1, stiffness = 1.0 }
forcing = { frequency = 0.6, term = [{ dof = 0, cos = 1.0 }] }
contact = [{ dof = 0, gap = 0.0 }]
law = { restitution = 0.9 })"),
             {.periods = 2000});
  const LongMotion& motion = found.motion;
  EXPECT_EQ(motion.verdict, LongRun::irregular) << motion.reason;
  ASSERT_EQ(motion.lyapunov.size(), 2U);
  EXPECT_GT(motion.lyapunov[0].value, 5.0 * motion.lyapunov[0].error);
  const StopStatistics& stop = motion.stops.front();
  const double sum = motion.lyapunov[0].value + motion.lyapunov[1].value;
  EXPECT_NEAR(sum, -0.1 + 2.0 * std::log(0.9) * stop.impacts_per_second.value, 1e-3);
  // What the stop takes is what the load gives less what the damper takes: positive, and known as a loss of
  // (1 - e) / (2 (1 + e)) J^2 / m at each impact.
  const double square = std::pow(*stop.impulse_mean, 2) + std::pow(*stop.impulse_deviation, 2);
  EXPECT_NEAR(stop.power->value, 0.05 / 1.9 * square * stop.impacts_per_second.value, 1e-9);
}

// sdof-stop: the multipliers are a pair of modulus 0.866928 (docs/theory.md).
TEST(LongMotion, ExponentsOfAnOrbitAreThoseOfItsMultipliers) {
  const Followed found = follow(read_scene(find_scene("sdof-stop")).problem);
  EXPECT_EQ(found.motion.verdict, LongRun::periodic) << found.motion.reason;
  EXPECT_EQ(found.motion.order, 1);
  EXPECT_NEAR(found.motion.lyapunov.front().value, std::log(0.866928) / found.period, 1e-6);
  ASSERT_TRUE(found.motion.trajectory);
  EXPECT_DOUBLE_EQ(found.motion.trajectory->period(), found.period);
}

// A clamped tube of four spans between four pairs of spring stops, driven across each span at 40 Hz:
// code_aster V5.02.301, without the dampers of its stops.
Problem tube_between_stops() {
  std::string terms, stops;
  for (int span = 0; span < 4; ++span) {
    for (int node = 0; node < 11; ++node)
      terms += "{ dof = " + std::to_string(24 * span + 2 * node) +
               ", sin = " + (span % 2 == 0 ? "4.138" : "-4.138") + " },";
    const std::string dof = std::to_string(24 * span + 22);
    stops += "[[contact]]\ndof = " + dof + "\ngap = 0.406e-3\n[[contact]]\nnormal = [[" + dof +
             ", -1.0]]\ngap = 0.406e-3\n";
  }
  return oscillator(R"(system = { kind = "beam", elements = 48, length = 2.436, area = 5.32892653865e-05, )"
                    R"(inertia = 1.45802760677e-09, young = 2.07e11, density = 7870.0, )"
                    R"(damping = { alpha = 0.1526, beta = 1.79e-5 } }
forcing = { frequency = 251.2, term = [)" +
                    terms + "] }\nlaw = { penalty = 1e5 }\n" + stops);
}

// From rest, over 0.17 to 0.25 s: code_aster has 23.98 and 24.54 N by two integrators, a march of 30 modes by
// central differences 24.13 N.
TEST(LongMotion, OfATubeBetweenStopsPushesItsEndAsOthersHaveIt) {
  const Problem problem = tube_between_stops();
  const ContactDynamics dynamics(problem);
  EventFlow flow(
      dynamics, 1e-10, [] { return false; }, Integrator::modal);
  FlowState state = flow.place(0.0, dynamics.at_rest());
  FlowRecord before, window;
  flow.advance(state, 0.17, before);
  window.dense = true;
  flow.advance(state, 0.08, window);
  StopSums sums(dynamics.contact_count());
  sums.take(window, 0.08);
  const std::vector<StopStatistics> stops = sums.statistics();
  ASSERT_EQ(stops.size(), 8U);
  EXPECT_NEAR(std::hypot(stops[6].force_rms->value, stops[7].force_rms->value), 24.2, 0.6);
}

// A chaotic motion that passes a stable motion of order 1 (largest multiplier 0.886) again and again: marches
// of another program over 21,000 periods never end there.
Problem passing_an_orbit() {
  return oscillator(R"(system = { kind = "sdof", mass = 0.82495, damping = 0.019289, stiffness = 1.5791 }
forcing = { frequency = 0.608718, term = [{ dof = 0, cos = 1.0 }] }
law = { penalty = 395.8 }
contact = [{ dof = 0, gap = 0.2263 }, { normal = [[0, -1.0]], gap = 0.09217 }])");
}

TEST(LongMotion, IsNotPeriodicWhereItPassesAStableOrbit) {
  const Followed found = follow(passing_an_orbit(), {.transient = 1200, .periods = 400});
  EXPECT_EQ(found.motion.verdict, LongRun::irregular)
      << found.motion.reason << " after " << found.motion.settled_after;
}

// The largest exponent by two motions side by side, without derivatives, the second brought near to the first
// again after each period.
double exponent_of_neighbours(const Problem& problem, int periods, Integrator integrator) {
  constexpr double kApart = 1e-5;
  const ContactDynamics dynamics(problem);
  EventFlow flow(
      dynamics, 1e-12, [] { return false; }, integrator);
  PeriodMap map(flow);
  const auto after = [&map](FlowState state, int count) {
    FlowRecord unused;
    map.apply(state, count, unused);
    return state;
  };
  FlowState one = after(flow.place(0.0, dynamics.at_rest()), 20);
  Eigen::VectorXd apart = Eigen::VectorXd::Unit(dynamics.states(), 0) * kApart;
  double sum = 0.0;
  for (int n = 0; n < periods; ++n) {
    const FlowState other = after(flow.place(0.0, map.unscaled(map.scaled(one.state) + apart)), 1);
    one = after(one, 1);
    apart = map.scaled(other.state) - map.scaled(one.state);
    sum += std::log(apart.norm() / kApart);
    apart *= kApart / apart.norm();
  }
  return sum / (periods * problem.forcing_period());
}

// Thirty periods remain once directions have turned: the error is wider, and holds what more periods have.
TEST(LongMotion, IsIrregularAfterFewPeriodsWithAWiderError) {
  const Problem problem = passing_an_orbit();
  const double neighbours = exponent_of_neighbours(problem, 150, Integrator::cvode);
  const LongMotion few = follow(problem, {.transient = 60, .periods = 40}).motion;
  EXPECT_EQ(few.verdict, LongRun::irregular) << few.reason;
  EXPECT_NEAR(few.lyapunov.front().value, neighbours, few.lyapunov.front().error + 0.03);
  EXPECT_LT(few.lyapunov.front().error, 0.1);
}

TEST(LongMotion, OfATubeBetweenStopsIsIrregular) {
  const Problem problem = tube_between_stops();
  const double neighbours = exponent_of_neighbours(problem, 100, Integrator::modal);
  const LongMotion tube = follow(problem, {.transient = 16, .periods = 80}).motion;
  EXPECT_EQ(tube.verdict, LongRun::irregular) << tube.reason;
  EXPECT_NEAR(tube.lyapunov.front().value, neighbours, tube.lyapunov.front().error + 0.2 * neighbours);
  EXPECT_LT(tube.lyapunov.front().error, 0.5 * neighbours);
}

LongMotion follow_until(const Problem& problem, const Deadline& deadline) {
  const ContactDynamics dynamics(problem);
  const EventFlow flow(
      dynamics, 1e-10, [] { return false; }, Integrator::modal);
  return follow_long_motion(dynamics, flow.place(0.0, dynamics.at_rest()),
                            {.transient = 10'000'000, .periods = 10'000'000}, deadline);
}

TEST(LongMotion, IsToldFromWhatTheTimeAllowed) {
  const LongMotion cut = follow_until(passing_an_orbit(), Deadline::after(0.5));
  EXPECT_EQ(cut.verdict, LongRun::irregular) << cut.reason;
  EXPECT_GT(cut.measured, 30);
  EXPECT_LT(cut.measured, 10'000'000);
  const LongMotion none = follow_until(passing_an_orbit(), Deadline::min());
  EXPECT_EQ(none.verdict, LongRun::undecided);
  EXPECT_EQ(none.reason, "not periodic, and only 0 periods could be measured: more time decides");
}

Problem impact_oscillator(const std::string& frequency) {
  return oscillator(
      "system = { kind = \"sdof\", mass = 1.0, damping = 0.05, stiffness = 1.0 }\nforcing = { frequency = " +
      frequency +
      ", term = [{ dof = 0, cos = 1.0 }] }\ncontact = [{ dof = 0, gap = 0.0 }]\nlaw = { restitution = 0.7 }");
}

State beside_the_stop() { return {.u = Eigen::VectorXd::Constant(1, -0.1), .v = Eigen::VectorXd::Zero(1)}; }

// Orders from a march in closed form by another program: past four and five doublings of a motion of two
// periods.
TEST(LongMotion, HasTheOrderOfTheLastDoubling) {
  const Followed sixteen = follow(impact_oscillator("2.7576"), {}, beside_the_stop());
  EXPECT_EQ(sixteen.motion.verdict, LongRun::periodic) << sixteen.motion.reason;
  EXPECT_EQ(sixteen.motion.order, 16);
  const Followed more = follow(impact_oscillator("2.7584"), {}, beside_the_stop());
  EXPECT_EQ(more.motion.verdict, LongRun::periodic) << more.motion.reason;
  EXPECT_EQ(more.motion.order, 32);
}

// Just before the doubling of its eight periods that march comes to it slowly: with an exponent near to 0.
TEST(LongMotion, IsNoTorusWhereDeviationsFadeSlowly) {
  const Problem problem = impact_oscillator("2.75725");
  const Followed found = follow(problem, {}, beside_the_stop());
  EXPECT_EQ(found.motion.verdict, LongRun::periodic) << found.motion.reason;
  EXPECT_EQ(found.motion.order, 8);
  const Followed later = follow(problem, {.periods = 600, .max_order = 4}, beside_the_stop());
  EXPECT_EQ(later.motion.verdict, LongRun::periodic) << later.motion.reason;
  EXPECT_EQ(later.motion.order, 8);
  const Followed never = follow(problem, {.max_order = 1}, beside_the_stop());
  EXPECT_EQ(never.motion.verdict, LongRun::undecided);
  EXPECT_NE(never.motion.reason.find("small deviations fade"), std::string::npos) << never.motion.reason;
}

// Past the last doubling that march never repeats.
TEST(LongMotion, IsNoTorusWhereChaosIsWeak) {
  const Followed found = follow(impact_oscillator("2.7588"), {}, beside_the_stop());
  EXPECT_EQ(found.motion.verdict, LongRun::irregular) << found.motion.reason << found.motion.order;
}

// A chain of two masses between springs whose chaotic transient lasts for thousands of periods.
TEST(LongMotion, IsPeriodicWhereChaosEndsWhileItIsMeasured) {
  const Followed found = follow(oscillator(
      R"(system = { kind = "chain", masses = [0.63137, 0.9754], dampers = [0.014803, 0.0071468], springs = [1.3889, 0.67056] }
forcing = { frequency = 0.618976, term = [{ dof = 1, cos = 1.0 }] }
contact = [{ normal = [[1, 1.0]], gap = 0.2688 }, { normal = [[0, -1.0]], gap = 0.05886 }]
law = { penalty = 31.33 })"));
  EXPECT_EQ(found.motion.verdict, LongRun::periodic) << found.motion.reason;
  EXPECT_LT(found.motion.lyapunov.front().value, 0.0);
}

// Damping so light that a deviation keeps 0.9998 of itself in a period, and a stop out of reach of the
// resonance of amplitude F / (c omega) = 0.5.
TEST(LongMotion, IsPeriodicWhereItFadesSlowly) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 6.366835e-05, stiffness = 1.0 }
forcing = { frequency = 1.0, term = [{ dof = 0, cos = 3.1834175e-05 }] }
contact = [{ dof = 0, gap = 1.0 }]
law = { penalty = 1.0 })"));
  EXPECT_EQ(found.motion.verdict, LongRun::periodic) << found.motion.reason;
  ASSERT_FALSE(found.motion.lyapunov.empty());
  EXPECT_NEAR(found.motion.lyapunov.front().value, std::log(0.9998) / found.period, 1e-9);
}

// Two masses and a spring stop (NLvib, example 03) past the Neimark-Sacker point at 0.61860687 rad/s: one of
// few random states goes to the torus, others to a motion of order 4.
TEST(LongMotion, ATorusHasTheExponentZero) {
  const Problem problem = oscillator(
      R"(system = { kind = "chain", masses = [1.0, 1.0], dampers = [0.03, 0.03], springs = [1.0, 1.0] }
forcing = { frequency = 0.61858, term = [{ dof = 0, cos = 0.1 }] }
contact = [{ dof = 1, gap = 1.0 }]
law = { penalty = 100.0 })");
  const ContactDynamics dynamics(problem);
  EventFlow flow(
      dynamics, 1e-10, [] { return false; }, Integrator::modal);
  std::seed_seq seeds{1U, 2U};
  std::mt19937_64 generator(seeds);
  const FlowState start = random_state(flow, generator);
  const LongMotion found = follow_long_motion(dynamics, start, {.periods = 3000}, Deadline());
  EXPECT_EQ(found.verdict, LongRun::quasi_periodic) << found.reason << found.order;
  EXPECT_NEAR(found.lyapunov[0].value, 0.0, found.lyapunov[0].error + 1e-4);
}

TEST(LongMotion, ComesToRestWithoutALoad) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 0.3, stiffness = 1.0 }
forcing = { frequency = 1.0 }
contact = [{ dof = 0, gap = 0.5 }]
law = { restitution = 0.5 })"),
             {}, {.u = Eigen::VectorXd::Constant(1, -2.0), .v = Eigen::VectorXd::Zero(1)});
  EXPECT_EQ(found.motion.verdict, LongRun::at_rest) << found.motion.reason;
}

// At its undamped eigenfrequency the amplitude grows by pi F / k each period.
TEST(LongMotion, IsUnboundedAtAnUndampedResonance) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 0.0, stiffness = 1.0 }
forcing = { frequency = 1.0, term = [{ dof = 0, cos = 1.0 }] }
)"));
  EXPECT_EQ(found.motion.verdict, LongRun::unbounded) << found.motion.reason;
}

// The scale is that of the gap: the amplitude is far below it, and grows all the same.
TEST(LongMotion, IsUnboundedAtAResonanceFarFromItsStop) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 0.0, stiffness = 1.0 }
forcing = { frequency = 1.0, term = [{ dof = 0, cos = 1.0 }] }
contact = [{ dof = 0, gap = 1e6 }]
law = { penalty = 1.0 })"),
             {.periods = 300});
  EXPECT_EQ(found.motion.verdict, LongRun::unbounded) << found.motion.reason;
}

// Pressed together by forces that no contact lets go, two free bodies swing as one: at the beginning of each
// period they stand still.
TEST(LongMotion, IsNotAtRestWhereItStandsStillOnceAPeriod) {
  const Followed found = follow(oscillator(
      R"(system = { kind = "chain", masses = [1.0, 1.0], dampers = [0.0, 0.0], springs = [0.0, 0.0] }
forcing = { frequency = 2.2, term = [{ dof = 0, cos = 0.3 }, { dof = 0, harmonic = 0, cos = 0.55 }, { dof = 1, harmonic = 0, cos = -0.55 }] }
contact = [{ between = [0, 1], gap = 0.0 }]
law = { restitution = 0.5 })"));
  EXPECT_EQ(found.motion.verdict, LongRun::periodic) << found.motion.reason;
}

// With so little damping that the amplitude grows for 1e5 periods: it is bounded by F / (c omega).
TEST(LongMotion, IsUndecidedWhereItStillGrowsToABound) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 3e-6, stiffness = 1.0 }
forcing = { frequency = 1.0, term = [{ dof = 0, cos = 1.0 }] }
contact = [{ dof = 0, gap = 1.0 }]
law = { penalty = 1e-9 })"));
  EXPECT_EQ(found.motion.verdict, LongRun::undecided);
  EXPECT_NE(found.motion.reason.find("slowest mode fades in 1.1e+05 periods"), std::string::npos)
      << found.motion.reason;
}

TEST(LongMotion, IsUndecidedWhereItIsFollowedForTooShort) {
  const Followed found =
      follow(oscillator(R"(system = { kind = "sdof", mass = 1.0, damping = 0.1, stiffness = 1.0 }
forcing = { frequency = 0.6, term = [{ dof = 0, cos = 1.0 }] }
contact = [{ dof = 0, gap = 0.0 }]
law = { restitution = 0.9 })"),
             {.transient = 50, .periods = 20});
  EXPECT_EQ(found.motion.verdict, LongRun::undecided);
  EXPECT_NE(found.motion.reason.find("20 periods"), std::string::npos) << found.motion.reason;
}

}  // namespace
}  // namespace signorini::long_motion_test
