// Parts that no spring holds: the scenes of the catalogue that carry the tag `clearance`, and published ones,
// against closed forms and flows that share no code with ours.

#include "tests/support/loose_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "methods/catalogue.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/flow/flow.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::loose_parts_test {
namespace {

constexpr double kGravity = 9.81;

Solution solved_by(const std::string& method, const Problem& problem) {
  return find_method(method).make({})->prepare(problem)->solve({});
}

Solution solved_by(const std::string& method, const std::string& scene) {
  return solved_by(method, load_scene(find_scene(scene)));
}

void expect_range(const Solution& solution, int contact, double least, double most, double tolerance) {
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Eigen::VectorXd x = solution.trajectory->sample(1 << 14).x.col(contact);
  EXPECT_NEAR(x.minCoeff(), least, tolerance);
  EXPECT_NEAR(x.maxCoeff(), most, tolerance);
}

/// Of all contacts over a period, phases of contact included [N s].
double total_impulse(const Solution& solution, int contact) {
  double sum = solution.trajectory->sample(1 << 16).force.col(contact).mean() * solution.trajectory->period();
  for (const Impulse& impulse : solution.trajectory->impulses())
    if (impulse.contact == contact) sum += impulse.value;
  return sum;
}

TEST(LooseParts, OfTheCatalogueMoveAsIndependentFlowsDo) {
  for (const char* method : {"exact-orbit", "event-driven", "hat-lcp"}) {
    SCOPED_TRACE(method);
    expect_range(solved_by(method, "clearance-gear"), 0, 0.8392488693, 1.2975814541, 2e-6);
  }
  // The mirror image at e = .7, from the closed form of one impact on each side.
  for (const char* method : {"exact-orbit", "event-driven"}) {
    const Solution pair = solved_by(method, "clearance-impact-pair");
    ASSERT_EQ(pair.verdict, Verdict::converged) << pair.message;
    ASSERT_EQ(pair.trajectory->impulses().size(), 2U) << method;
    for (const Impulse& impulse : pair.trajectory->impulses()) EXPECT_NEAR(impulse.value, -0.00707761, 1e-8);
  }
}

// Two gears that nothing but their teeth and equal dampers per mass hold: their difference moves as the one
// mass of test::gear_backlash, and both may be anywhere together.
TEST(LooseParts, APairThatTeethAloneHoldMovesAsItsDifferenceDoes) {
  const auto diagonal = [](double value) {
    return SparseMatrix((value * Eigen::Matrix2d::Identity()).sparseView());
  };
  Problem pair = test::gear_backlash();
  pair.kind = "chain";
  pair.edit_structure([&](Structure& s) {
    s.mass = diagonal(2.0);
    s.damping = diagonal(0.2);
    s.stiffness = diagonal(0.0);
  });
  for (ForceTerm term : std::vector(pair.force)) {
    term.dof = 1;
    term.cos *= -1.0;
    pair.force.push_back(term);
  }
  pair.contacts[0].normal = {{0, 1.0}, {1, -1.0}};
  pair.contacts[1].normal = {{0, -1.0}, {1, 1.0}};
  for (const char* method : {"exact-orbit", "event-driven", "hat-lcp"}) {
    SCOPED_TRACE(method);
    expect_range(solved_by(method, pair), 0, 0.8392488693, 1.2975814541, 2e-6);
  }
  const Solution exact = solved_by("exact-orbit", pair);
  EXPECT_NE(exact.message.find("may be anywhere"), std::string::npos) << exact.message;
  const OrbitSearch search = OrbitFinder(pair).find(*exact.trajectory, {});
  ASSERT_TRUE(search.orbit.certified()) << search.orbit.reason;
  EXPECT_EQ(search.orbit.multipliers.values.size(), 0) << "one of them is 1";
}

// Two stable motions, mirror images, beside one that is its own image: an independent march from rest, and
// from the other side, finds the former.
TEST(LooseParts, AToolBetweenTwoStopsHasASidedMotionThatIsStable) {
  const Problem tool = load_scene(find_scene("clearance-tool"));
  const Solution marched = solved_by("event-driven", tool);
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  const Eigen::VectorXd x = marched.trajectory->sample(1 << 14).x.col(0);
  const bool mirrored = x.maxCoeff() > -x.minCoeff();
  EXPECT_NEAR(std::max(x.maxCoeff(), -x.minCoeff()), 0.03833827, 1e-7);
  EXPECT_NEAR(std::min(x.maxCoeff(), -x.minCoeff()), 0.03001709, 1e-7);
  const Solution polished = test::solve<ExactOrbitMethod>(tool, {}, marched.trajectory);
  expect_range(polished, 0, mirrored ? -0.03001709 : -0.03833827, mirrored ? 0.03833827 : 0.03001709, 1e-7);
  EXPECT_NE(polished.message.find("largest multiplier 0.705347"), std::string::npos) << polished.message;
}

TEST(LooseParts, WhatLiesByItsWeightIsHeldByTheImpulseOfItsWeight) {
  for (const char* scene :
       {"clearance-ball-at-rest", "clearance-bouncing-ball", "clearance-rest-on-spring"}) {
    const Problem problem = load_scene(find_scene(scene));
    for (const char* method : {"exact-orbit", "event-driven"}) {
      const Solution solution = solved_by(method, problem);
      ASSERT_EQ(solution.verdict, Verdict::converged) << scene << ", " << method << ": " << solution.message;
      EXPECT_NEAR(total_impulse(solution, 0), -kGravity * solution.trajectory->period(), 2e-4)
          << scene << ", " << method;
    }
  }
  const Solution rest = solved_by("exact-orbit", "clearance-ball-at-rest");
  EXPECT_LT(rest.trajectory->sample(64).x.cwiseAbs().maxCoeff(), 1e-12) << "it does not leave the table";
}

// The housing and what rattles in it exchange what the damper does not take: both strike equally often.
TEST(LooseParts, AnImpactDamperKeepsItsMassInTheHousing) {
  const Solution damper = solved_by("event-driven", "clearance-impact-damper");
  ASSERT_EQ(damper.verdict, Verdict::converged) << damper.message;
  const Eigen::MatrixXd x = damper.trajectory->sample(4096).x;
  EXPECT_LE(x.maxCoeff(), 5.0 + 1e-9);
  EXPECT_NEAR(total_impulse(damper, 0), total_impulse(damper, 1), 1e-8) << "no mean force on a free mass";
}

// Ansys VM65: a ball of 0.5 lbf s^2/in falls from rest onto a spring of 1973.92 lbf/in, g = 386 in/s^2. What
// it is dropped from is one inch of free flight: the period has a closed form.
TEST(LooseParts, ABallBouncesOnASpringWithThePeriodOfTheClosedForm) {
  constexpr double kMass = 0.5, kSpring = 1973.92, kAcceleration = 386.0, kDrop = 1.0;
  Problem ball = test::loose_mass(kMass, 0.0);
  ball.frequency = 31.0;
  ball.force = {{.dof = 0, .harmonic = 0, .cos = kMass * kAcceleration}};
  ball.contacts = {{.normal = {{0, 1.0}}, .gap = 0.0}};
  ball.set_law(Penalty{.stiffness = {kSpring}});
  const double w = std::sqrt(kSpring / kMass), sag = kAcceleration / (w * w);
  const double speed = std::sqrt(2.0 * kAcceleration * kDrop), amplitude = std::hypot(sag, speed / w);
  const double pressed = 2.0 / w * (std::numbers::pi - std::atan2(speed / w, sag));
  const double period = 2.0 * speed / kAcceleration + pressed;

  const ContactDynamics dynamics(ball);
  EventFlow flow(
      dynamics, 1e-12, [] { return false; }, Integrator::modal);
  FlowState state =
      flow.place(0.0, {.u = Eigen::VectorXd::Constant(1, -kDrop), .v = Eigen::VectorXd::Zero(1)});
  FlowRecord record;
  flow.advance(state, period, record);
  EXPECT_NEAR(state.state.u[0], -kDrop, 1e-10);
  EXPECT_NEAR(state.state.v[0], 0.0, 1e-9 * speed);
  ASSERT_EQ(record.events.size(), 2U);
  EXPECT_NEAR(record.events[0].time, speed / kAcceleration, 1e-12);
  EXPECT_NEAR(record.events[1].time - record.events[0].time, pressed, 1e-12);
  EXPECT_NEAR(sag + amplitude, 0.5506656, 1e-6) << "the published deflection";
  EXPECT_NEAR(period, 0.2008897197, 1e-10) << "the published period";
}

// A rigid bar before two springs that it meets at one instant. From rest it would stay symmetric for ever, on
// a motion of four periods that nothing but symmetry keeps: the least pitch leaves it for that of one period.
TEST(SymmetricBar, IsMarchedToTheMotionThatPitchLeavesAlone) {
  Problem bar = test::loose_mass(1.0, 0.0);
  bar.edit_structure([](Structure& s) {  // heave and pitch
    const auto diagonal = [](double heave, double pitch) {
      return SparseMatrix(Eigen::Matrix2d(Eigen::Vector2d(heave, pitch).asDiagonal()).sparseView());
    };
    s.mass = diagonal(1.0, 1.0 / 12.0);
    s.damping = diagonal(0.1, 0.0125);
    s.stiffness = diagonal(1.0, 17.0 / 120.0);
  });
  bar.frequency = 2.2;
  bar.force = {{.dof = 0, .cos = 1.0}};
  bar.contacts = {{.normal = {{0, 1.0}, {1, 0.4}}, .gap = 0.2},
                  {.normal = {{0, 1.0}, {1, -0.4}}, .gap = 0.2}};
  bar.set_law(Penalty{.stiffness = {100.0, 100.0}});
  const Solution marched = test::solve<EventDriven>(bar, {.flow = Integrator::modal});
  const Solution exact = test::solve<ExactOrbitMethod>(bar, {});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  EXPECT_LT(test::relative_distance(*marched.trajectory, *exact.trajectory), 1e-6);
  expect_range(marched, 0, -0.490592, 0.218895, 2e-6);  // an independent flow
}

// A contact between two masses of a free chain feels no motion of all as one, to rounding: x has one mean
// alone.
TEST(LooseParts, AStopWithinAFreeChainLeavesTheMeanOfItsOwnDisplacement) {
  const Problem problem = parse_scene(
      "schema = 1\nname = \"free\"\n[system]\nkind = \"chain\"\nmasses = [1.3, 0.7, 0.9]\ndampers = [0.0, "
      "0.1, 0.05]\nsprings = [0.0, 1.7, 2.3]\n[forcing]\nfrequency = 1.9\nterm = [{ dof = 0, cos = 0.8 }]\n"
      "[[contact]]\nbetween = [0, 2]\ngap = 0.15\nrestitution = 0.6\n",
      "free.toml");
  const Solution exact = solved_by("exact-orbit", problem), grid = solved_by("hat-lcp", problem);
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  ASSERT_EQ(grid.verdict, Verdict::converged) << grid.message;
  EXPECT_LT(test::relative_distance(*grid.trajectory, *exact.trajectory), 0.02);
}

// The oscillator's impulse is that of its closed form (m = k = 1, d = 0.1); a sine on a mass that nothing
// damps would carry it away from rest.
TEST(LooseParts, IdleMassesWithoutDampingChangeNothingBesideThem) {
  const auto diagonal = [](double first, double second, double third) {
    return SparseMatrix(Eigen::MatrixXd(Eigen::Vector3d(first, second, third).asDiagonal()).sparseView());
  };
  Problem problem = test::loose_mass(1.0, 0.1);
  problem.edit_structure([&](Structure& s) {
    s.mass = diagonal(1.0, 0.6, 0.4);
    s.damping = diagonal(0.1, 0.0, 0.0);
    s.stiffness = diagonal(1.0, 0.0, 0.0);
  });
  problem.frequency = 2.2;
  problem.force = {{.dof = 0, .cos = 1.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.2}};
  problem.set_law(Restitution{0.8});
  for (const bool loaded : {false, true}) {
    if (loaded) problem.force.push_back({.dof = 1, .sin = 1.0});
    for (const char* method : {"exact-orbit", "event-driven"}) {
      SCOPED_TRACE(testing::Message() << method << (loaded ? ", loaded" : ""));
      const Solution solution = solved_by(method, problem);
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      ASSERT_EQ(solution.trajectory->impulses().size(), 1U);
      EXPECT_NEAR(solution.trajectory->impulses()[0].value, -0.7998435577597911, 1e-7);
    }
  }
}

// The events of such a motion are none, and tell nothing of its mean: the state does.
TEST(LooseParts, AMotionThatTouchesNothingLeadsToItself) {
  Problem floating = test::loose_mass(1.0, 0.3);
  floating.frequency = 1.68882;
  floating.force = {{.dof = 0, .cos = 0.1368}};
  floating.contacts = {{.normal = {{0, 1.0}}, .gap = 0.3161}, {.normal = {{0, -1.0}}, .gap = 0.2305}};
  floating.set_law(Restitution{0.9});
  const Solution marched = test::solve<EventDriven>(floating, {.flow = Integrator::modal});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  SearchOptions options;
  options.free_families = FreeFamilies::first;
  const OrbitSearch search = OrbitFinder(floating).find(*marched.trajectory, options);
  ASSERT_TRUE(search.orbit.certified()) << search.orbit.reason;
  EXPECT_LT(test::relative_distance(*marched.trajectory, *search.orbit.trajectory), 1e-6);
}

}  // namespace
}  // namespace signorini::loose_parts_test
