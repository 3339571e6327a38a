// The closed-form flow against the equation of motion, closed forms, and CVODE.

#include "methods/kernels/event_flow/linear_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "methods/event_driven/event_driven.hpp"
#include "methods/kernels/event_flow/flow.hpp"
#include "methods/kernels/event_flow/rigid_events.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

State random_state(int n) {
  std::srand(5);
  return {.u = Eigen::VectorXd::Random(n), .v = Eigen::VectorXd::Random(n)};
}

// Largest violation of u'' = F(t, u, u') along the arc, relative to the largest acceleration met or expected.
double defect(const ContactDynamics& dynamics, const LinearArc& arc, double from, double to) {
  double worst = 0.0, scale = dynamics.scales().acceleration;
  for (int i = 0; i <= 40; ++i) {
    const double t = from + (to - from) * i / 40;
    State state;
    arc.state(t, state);
    Eigen::VectorXd a, expected(dynamics.size());
    arc.acceleration(t, a);
    dynamics.acceleration(arc.flow().mode(), t, state.u, state.v, expected);
    worst = std::max(worst, (a - expected).lpNorm<Eigen::Infinity>());
    scale = std::max(scale, expected.lpNorm<Eigen::Infinity>());
  }
  return worst / scale;
}

void expect_flow(const Problem& problem, const std::vector<bool>& closed, FlowForm form,
                 const std::string& name) {
  SCOPED_TRACE(name);
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics, form);
  const LinearFlow& flow = flows.of(closed);
  State start = random_state(dynamics.size());
  const RigidEvents events(dynamics, 1e-12);
  if (dynamics.rigid()) events.hold(start, flow.mode());
  LinearArc arc;
  arc.start(flow, 0.3, start);
  State state;
  arc.state(0.3, state);
  EXPECT_LT((state.u - start.u).norm() + (state.v - start.v).norm(), 1e-13 * (1.0 + start.v.norm()));
  EXPECT_LT(defect(dynamics, arc, 0.3, 4.0), 1e-12);
  // lambda and its derivative as the equation of motion gives them.
  arc.state(1.7, state);
  const MotionDerivatives motion = dynamics.derivatives(flow.mode(), 1.7, state, 4);
  for (int j = 0; j < dynamics.contact_count(); ++j) {
    const double scale = 1.0 + motion.lambda.row(j).cwiseAbs().maxCoeff();
    EXPECT_NEAR(arc.force(j, 1.7), motion.lambda(j, 0), 1e-12 * scale);
    EXPECT_NEAR(arc.force(j, 1.7, 1), motion.lambda(j, 1), 1e-11 * scale);
    for (int k = 0; k <= 3; ++k) {
      const double x = dynamics.directions().col(j).dot(motion.u.col(k));
      EXPECT_NEAR(arc.displacement(j, 1.7, k), x, 1e-11 * (1.0 + motion.u.col(k).cwiseAbs().maxCoeff()));
    }
  }
  // The transition matrix: two arcs differ by it, exactly, for the motion is linear.
  State moved = start;
  moved.u += 0.1 * random_state(dynamics.size()).v;
  moved.v -= 0.2 * random_state(dynamics.size()).u;
  if (dynamics.rigid()) events.hold(moved, flow.mode());
  LinearArc other;
  other.start(flow, 0.3, moved);
  State end, other_end;
  arc.state(2.5, end);
  other.state(2.5, other_end);
  const int n = dynamics.size();
  Eigen::VectorXd before(2 * n), after(2 * n);
  before << moved.u - start.u, moved.v - start.v;
  after << other_end.u - end.u, other_end.v - end.v;
  EXPECT_LT((flow.transition(2.2) * before - after).norm(), 1e-12 * (1.0 + after.norm()));
}

TEST(LinearFlow, SatisfiesTheEquationOfMotionInEveryMode) {
  for (const FlowForm form : {FlowForm::automatic, FlowForm::exponential}) {
    const std::string name = form == FlowForm::automatic ? "modal " : "exponential ";
    expect_flow(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}), {false}, form,
                name + "one mass");
    expect_flow(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}), {true}, form,
                name + "one mass, held");
    expect_flow(test::skew_damped_pair(0.5), {false}, form, name + "pair");
    expect_flow(test::skew_damped_pair(0.5), {true}, form, name + "pair, held");
    expect_flow(test::penalty_oscillator(1e4), {true}, form, name + "spring stop");
    expect_flow(test::stopped_chain(5, 0.5, 2), {true, false}, form, name + "chain");
    expect_flow(test::stopped_chain(5, 0.5, 2), {true, true}, form, name + "chain, both held");
  }
}

TEST(LinearFlow, TakesTheExponentialWhereModesFail) {
  // Critical damping, a rigid-body motion, an undamped resonance.
  for (const auto& oscillator : {test::ImpactOscillator{.damping = 2.0, .frequency = 1.3},
                                 test::ImpactOscillator{.damping = 0.0, .stiffness = 0.0, .frequency = 1.3},
                                 test::ImpactOscillator{.damping = 0.0, .frequency = 1.0}}) {
    const Problem problem = test::to_problem(oscillator);
    const ContactDynamics dynamics(problem);
    EXPECT_FALSE(LinearFlow(dynamics, dynamics.mode({false})).modal());
    expect_flow(problem, {false}, FlowForm::automatic, "degenerate");
  }
}

TEST(LinearFlow, ResonanceGrowsLinearly) {
  // x'' + x = cos t from rest: x = t sin(t) / 2.
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0});
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  LinearArc arc;
  arc.start(flows.of({false}), 0.0, {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)});
  for (const double t : {0.5, 3.0, 20.0}) EXPECT_NEAR(arc.displacement(0, t), 0.5 * t * std::sin(t), 1e-12);
}

// One period of both flows through impacts, sticking and springs.
void expect_same_flow(const Problem& problem, double tolerance, const std::string& name) {
  SCOPED_TRACE(name);
  const ContactDynamics dynamics(problem);
  const auto never = [] { return false; };
  EventFlow cvode(dynamics, 1e-13, never), modal(dynamics, 1e-13, never, Integrator::modal);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(dynamics.size());
  FlowState a = cvode.place(0.0, {.u = zero, .v = zero}), b = a;
  FlowRecord kept_a, kept_b;
  kept_a.tangent = kept_b.tangent = true;
  const double duration = 2.4 * problem.period();
  cvode.advance(a, duration, kept_a);
  modal.advance(b, duration, kept_b);
  ASSERT_EQ(kept_a.events.size(), kept_b.events.size());
  ASSERT_GT(kept_a.events.size(), 0U);
  for (std::size_t i = 0; i < kept_a.events.size(); ++i) {
    EXPECT_EQ(kept_a.events[i].kind, kept_b.events[i].kind);
    EXPECT_EQ(kept_a.events[i].contact, kept_b.events[i].contact);
    EXPECT_NEAR(kept_a.events[i].time, kept_b.events[i].time, 1e3 * tolerance);
  }
  EXPECT_LT((a.state.u - b.state.u).lpNorm<Eigen::Infinity>(), tolerance * dynamics.scales().displacement);
  EXPECT_LT((a.state.v - b.state.v).lpNorm<Eigen::Infinity>(), tolerance * dynamics.scales().velocity);
  EXPECT_LT((kept_a.derivative - kept_b.derivative).norm(), 1e-6 * (1.0 + kept_a.derivative.norm()));
  EXPECT_EQ(modal.rhs_evaluations(), 0);
}

TEST(ModalEventFlow, AgreesWithCvode) {
  expect_same_flow(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}), 1e-10, "S-A");
  expect_same_flow(test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.0}),
                   1e-11, "sticking");
  expect_same_flow(test::to_problem({.damping = 0.02, .frequency = 0.5, .gap = 0.2, .restitution = 0.5}),
                   1e-11, "chatter");
  expect_same_flow(test::penalty_oscillator(1e3), 1e-10, "spring stop");
  expect_same_flow(test::skew_damped_pair(0.5), 1e-10, "pair");
  expect_same_flow(test::stopped_chain(4, 0.0, 2), 1e-10, "chain that sticks");
}

TEST(ModalEventFlow, ReachesTheClosedFormOrbit) {
  for (const double e : {1.0, 0.8, 0.5}) {
    const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = e};
    const auto orbit = test::single_impact_orbits(oscillator).front();
    const Solution solution = test::solve<EventDriven>(test::to_problem(oscillator),
                                                       {.tolerance = 1e-13, .flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_LT(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }), 2e-12);
  }
}

}  // namespace
}  // namespace signorini
