// The method around the kernel: options, support, guesses, messages.

#include "methods/exact_orbit/exact_orbit_method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include "methods/catalogue.hpp"
#include "methods/flow/flow.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::exact_orbit_method_test {
namespace {

std::string refusal(const ExactOrbitMethod::Options& options) {
  try {
    const ExactOrbitMethod method(options);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return {};
}

TEST(ExactOrbitMethod, RefusesOptionsOutOfRange) {
  EXPECT_NE(refusal({.samples = 7}).find("samples = 7 ("), std::string::npos);
  EXPECT_NE(refusal({.refinements = 5}).find("refinements = 5 ("), std::string::npos);
  EXPECT_NE(refusal({.restarts = -1}).find("restarts = -1 ("), std::string::npos);
  EXPECT_NE(refusal({.tolerance = 1e-3}).find("tolerance = 0.001 ("), std::string::npos);
  EXPECT_NE(refusal({.max_iterations = 0}).find("max_iterations = 0 ("), std::string::npos);
  EXPECT_NE(refusal({.marching = -1}).find("marching = -1 ("), std::string::npos);
  EXPECT_EQ(refusal({}), "");
}

TEST(ExactOrbitMethod, IsInTheCatalogueAndDeclaresTheScenesOwnLaw) {
  const MethodEntry& entry = find_method("exact-orbit");
  const auto method = entry.make({});
  const Problem rigid = test::to_problem({.restitution = 0.4});
  EXPECT_TRUE(method->supports(rigid).ok);
  EXPECT_TRUE(law_matches(method->law(rigid), rigid.law()));
  const Problem spring = test::penalty_oscillator(100.0);
  EXPECT_TRUE(law_matches(method->law(spring), spring.law()));
}

TEST(ExactOrbitMethod, TakesAsManyNodesAsTheLoadNeeds) {
  Problem problem = test::to_problem({});
  problem.force.push_back({.dof = 0, .harmonic = 40, .cos = 0.1, .sin = 0.0});
  ASSERT_TRUE(ExactOrbitMethod({}).supports(problem).ok);
  const Solution own = test::solve<ExactOrbitMethod>(problem, {});
  const Solution asked = test::solve<ExactOrbitMethod>(problem, {.samples = 256});
  ASSERT_EQ(own.verdict, Verdict::converged) << own.message;
  ASSERT_EQ(asked.verdict, Verdict::converged) << asked.message;
  EXPECT_LT(test::relative_distance(*own.trajectory, *asked.trajectory), 1e-10);
}

TEST(ExactOrbitMethod, AGuessIsTakenFirst) {
  // From the subharmonic's own branch the same orbit comes back, in a step or two.
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.5});
  const auto cold = test::cold_orbit(problem);
  ASSERT_TRUE(cold.orbit);
  const Solution warm = test::solve<ExactOrbitMethod>(problem, {}, cold.orbit);
  ASSERT_EQ(warm.verdict, Verdict::converged);
  EXPECT_NE(warm.message.find("from the guess"), std::string::npos) << warm.message;
  EXPECT_LE(*warm.work.iterations, 2);
  EXPECT_LT(test::relative_distance(*warm.trajectory, *cold.orbit), 1e-13);
}

TEST(ExactOrbitMethod, SolvesAreRepeatable) {
  const Problem problem = test::stopped_chain(3, 0.5, 2, 1.1);
  const ExactOrbitMethod method({});
  const auto prepared = method.prepare(problem);
  const Solution first = prepared->solve({}), second = prepared->solve({});
  ASSERT_EQ(first.verdict, Verdict::converged) << first.message;
  EXPECT_EQ(first.message, second.message);
  EXPECT_EQ((first.trajectory->sample(100).x - second.trajectory->sample(100).x).norm(), 0.0);
}

// Driven at its undamped resonance the oscillator would gain pi F / (m omega) of speed in a period; one
// impulse of pi F / omega at the phase 0 takes it back. That orbit is found, or nothing is claimed.
TEST(ExactOrbitMethod, ClaimsNothingButTheClosedFormAtAnUndampedResonance) {
  for (const double e : {1.0, 0.8}) {
    const Problem problem =
        test::to_problem({.damping = 0.0, .frequency = 1.0, .gap = 0.2, .restitution = e});
    const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
    if (solution.verdict != Verdict::converged) {
      EXPECT_EQ(e, 1.0);  // no impact loses energy either, and the equations are singular nearby
      EXPECT_NE(solution.message.find("no exact orbit: "), std::string::npos) << solution.message;
      continue;
    }
    ASSERT_EQ(solution.trajectory->impulses().size(), 1U);
    EXPECT_NEAR(solution.trajectory->impulses()[0].value, -std::numbers::pi, 1e-10);
    EXPECT_NEAR(std::sin(0.5 * solution.trajectory->impulses()[0].time), 0.0, 1e-10);
  }
}

// The grid's path of pivots ends on a ray, and the free motion that is left passes the stop: shooting from
// there failed on six grids, some 270 Newton steps.
TEST(ExactOrbitMethod, MarchesOnWhereTheGridHasNoAnswer) {
  const test::ImpactOscillator oscillator{.damping = 0.003, .frequency = 1.6, .gap = 0.5};
  const Solution solution = test::solve<ExactOrbitMethod>(test::to_problem(oscillator), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("from N = 64 by "), std::string::npos) << solution.message;
  EXPECT_LE(*solution.work.iterations, 60);
  const auto exact = test::single_impact_orbits(oscillator).front();
  EXPECT_LT(test::relative_error(*solution.trajectory, [&](double t) { return exact.x(t); }), 1e-10);
}

// The tube of code_aster V5.02.301: the march over its eight stops never settles. The flow that looks for
// events by itself comes back to the state of the orbit, unstable as that is.
TEST(ExactOrbitMethod, FindsAnUnstableOrbitOfATubeAmongItsStops) {
  for (const char* name : {"sdnl301", "sdnl301d"}) {
    const Problem problem = load_scene(find_scene(name));
    const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(solution.verdict, Verdict::converged) << name << ": " << solution.message;
    const auto* orbit = dynamic_cast<const ExactTrajectory*>(solution.trajectory.get());
    ASSERT_NE(orbit, nullptr);
    const FlowState& start = orbit->orbit().start;
    EXPECT_GE(orbit->orbit().events.size(), 8U) << name;
    const ContactDynamics dynamics(problem);
    EventFlow flow(
        dynamics, 1e-12, [] { return false; }, Integrator::modal);
    FlowState end = start;
    FlowRecord record;
    flow.advance(end, problem.period(), record);
    EXPECT_LT(dynamics.scales().distance(end.state, start.state), 1e-8) << name;
  }
}

TEST(ExactOrbitMethod, SaysWhatStoppedEachAttempt) {
  // Undamped and resonant: every coarse answer is round-off of a singular structure, further off than one
  // step of Newton.
  const Problem problem =
      test::to_problem({.damping = 0.0, .frequency = 1.0, .gap = 50.0, .restitution = 0.5});
  const Solution solution = test::solve<ExactOrbitMethod>(
      problem, {.refinements = 1, .restarts = 1, .max_iterations = 1, .marching = 0});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  for (const char* attempt : {"no exact orbit: ", "N = 64", "N = 64 (cover 1)", "N = 256"})
    EXPECT_NE(solution.message.find(attempt), std::string::npos) << solution.message;
}

// Elastic impacts of a beam whose high modes are damped: thousands of them, lower and lower, and then
// contact. The values are of another program, which resolves 2,364 impacts a period in closed form (1e-9 of
// the motion).
TEST(ExactOrbitMethod, TakesElasticImpactsThatFadeForContact) {
  const Problem problem = parse_scene(R"(
schema = 1
name = "fading"
[system]
kind = "beam"
elements = 5
length = 1.0
area = 1.0
inertia = 1.0
young = 1.0
density = 1.0
damping = { modal = [0.05233, 0.1, 0.3] }
[forcing]
frequency = 5.95222
[[forcing.term]]
dof = 8
harmonic = 1
cos = 0.6
sin = 0
[[contact]]
normal = [[8, 1.0]]
gap = 0.0394392
[law]
restitution = 1.0
)",
                                      "fading");
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("complete chattering: "), std::string::npos) << solution.message;
  EXPECT_NEAR(solution.trajectory->sample(64).x(0, 0), -0.245298411556, 1e-8);
  const auto events = solution.trajectory->events();
  ASSERT_TRUE(events);
  EXPECT_LT(events->size(), 400U);
  const auto opening = std::ranges::find(*events, ContactEvent::Kind::open,
                                         [](const ContactEvent& event) { return event.kind; });
  ASSERT_NE(opening, events->end());
  EXPECT_NEAR(opening->time, 0.4463995035, 1e-8);
}

// Parts that no spring holds: an independent flow, and closed forms of impulse and multipliers.
TEST(ExactOrbitMethod, SolvesAGearInItsBacklash) {
  const Solution solution = test::solve<ExactOrbitMethod>(test::gear_backlash(), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Eigen::VectorXd x = solution.trajectory->sample(8192).x.col(0);
  // From rest, each stretch in closed form, 130 periods on.
  EXPECT_NEAR(x.minCoeff(), 0.8392488693109, 1e-8);
  EXPECT_NEAR(x.maxCoeff(), 1.2975814540848, 1e-8);
  EXPECT_NE(solution.message.find("largest multiplier 0.705347"), std::string::npos) << solution.message;
}

TEST(ExactOrbitMethod, BalancesTheWeightOfABallByItsImpulses) {
  const Solution solution = test::solve<ExactOrbitMethod>(test::bouncing_ball(), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples motion = solution.trajectory->sample(65536);
  double impulse = motion.force.col(0).mean() * solution.trajectory->period();  // while it lies
  for (const Impulse& one : solution.trajectory->impulses()) impulse += one.value;
  EXPECT_NEAR(impulse, -test::kBallImpulse, 1e-4);
}

// A mass that floats between the ends of a box that moves, 0.022 m to each: e = 0.7, two impacts per period.
TEST(ExactOrbitMethod, FindsTheImpactsOfALooseMassInABox) {
  Problem pair = test::loose_mass(0.01, 0.0);
  pair.frequency = 4.0 * std::numbers::pi;
  pair.force = {{.dof = 0, .cos = 0.01 * 0.02, .omega_power = 2}};
  pair.contacts = {{.normal = {{0, 1.0}}, .gap = 0.022}, {.normal = {{0, -1.0}}, .gap = 0.022}};
  pair.set_law(Restitution{0.7});
  const Solution solution = test::solve<ExactOrbitMethod>(pair, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  ASSERT_EQ(solution.trajectory->impulses().size(), 2U);
  for (const Impulse& impulse : solution.trajectory->impulses())
    EXPECT_NEAR(impulse.value, -0.00707761, 1e-8);
}

// The load is too weak to reach a stop: any mean within the clearances is a motion, and it is told as such.
TEST(ExactOrbitMethod, TellsAMotionThatTouchesNothingAsOneOfAFamily) {
  for (const double damping : {0.3, 0.0}) {
    Problem floating = test::loose_mass(2.0, damping);
    floating.frequency = 1.7;
    floating.force = {{.dof = 0, .cos = 0.5}};
    floating.contacts = {{.normal = {{0, 1.0}}, .gap = 0.3}, {.normal = {{0, -1.0}}, .gap = 0.25}};
    for (const Law& law : {Law{Restitution{0.0}}, Law{Penalty{.stiffness = {50.0, 50.0}}}}) {
      floating.set_law(law);
      const Solution solution = test::solve<ExactOrbitMethod>(floating, {});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      EXPECT_NE(solution.message.find("one of a family of free motions"), std::string::npos)
          << solution.message;
      const Eigen::VectorXd x = solution.trajectory->sample(4096).x.col(0);
      const double amplitude = 0.5 / std::abs(std::complex<double>(-2.0 * 1.7 * 1.7, 1.7 * damping));
      EXPECT_NEAR(0.5 * (x.maxCoeff() - x.minCoeff()), amplitude, 1e-6 * amplitude);
      EXPECT_LE(x.maxCoeff(), 0.3);
      EXPECT_GE(x.minCoeff(), -0.25);
    }
  }
}

// A loose mass that a damper drags along in its housing: about the middle it would touch nothing, about where
// the coarse motion leaves it, it would graze. The family has room between the stops.
TEST(ExactOrbitMethod, MovesAFreeMotionClearOfTheStops) {
  Problem damper = test::loose_mass(1.0, 0.0);
  const Eigen::Matrix2d M = Eigen::Vector2d(1.76778, 0.16578).asDiagonal(),
                        K = Eigen::Vector2d(1.36599, 0.0).asDiagonal();
  const Eigen::Matrix2d D{{0.23517, -0.17702}, {-0.17702, 0.17702}};
  damper.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(M).sparseView();
    s.damping = Eigen::MatrixXd(D).sparseView();
    s.stiffness = Eigen::MatrixXd(K).sparseView();
  });
  damper.frequency = 1.92133;
  damper.force = {{.dof = 0, .cos = 1.0}};
  damper.contacts = {{.normal = {{0, 1.0}, {1, -1.0}}, .gap = 0.143524},
                     {.normal = {{1, 1.0}, {0, -1.0}}, .gap = 0.551282}};
  damper.set_law(Restitution{0.3});
  const Solution solution = test::solve<ExactOrbitMethod>(damper, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const std::complex<double> i_w(0.0, damper.frequency);
  const auto entry = [&](int i, int j) { return i_w * (i_w * M(i, j) + D(i, j)) + K(i, j); };
  const std::complex<double> determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
  const double amplitude = std::abs((entry(1, 1) + entry(1, 0)) / determinant);  // of u_0 - u_1
  const Eigen::VectorXd x = solution.trajectory->sample(4096).x.col(0);
  EXPECT_NEAR(0.5 * (x.maxCoeff() - x.minCoeff()), amplitude, 1e-6 * amplitude);
  EXPECT_LT(x.maxCoeff(), 0.143524);
  EXPECT_GT(x.minCoeff(), -0.551282);
}

TEST(ExactOrbitMethod, DoesNotMindAMassBesideTheProblem) {
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  Problem problem = test::to_problem(oscillator);
  problem.edit_structure([](Structure& s) {
    for (SparseMatrix* matrix : {&s.mass, &s.damping, &s.stiffness}) {
      const double own = matrix->coeff(0, 0);
      *matrix = SparseMatrix(2, 2);
      matrix->insert(0, 0) = own;
    }
    s.mass.insert(1, 1) = 1.0;
    s.damping.insert(1, 1) = 0.2;
  });
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto exact = test::single_impact_orbits(oscillator).front();
  EXPECT_LT(test::relative_error(*solution.trajectory, [&](double t) { return exact.x(t); }), 1e-10);
  EXPECT_NE(solution.message.find("may be anywhere"), std::string::npos) << solution.message;
}

TEST(ExactOrbitMethod, SaysThatAnUnbalancedLoadHasNoPeriodicMotion) {
  Problem ball = test::bouncing_ball();
  ball.force.front().cos = -9.81;
  try {
    const Solution solution = test::solve<ExactOrbitMethod>(ball, {});
    FAIL() << solution.message;
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no periodic motion"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace signorini::exact_orbit_method_test
