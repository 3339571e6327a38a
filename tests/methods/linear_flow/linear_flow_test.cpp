// The closed-form flow against the equation of motion, closed forms, and CVODE.

#include "methods/linear_flow/linear_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "methods/event_driven/event_driven.hpp"
#include "methods/flow/flow.hpp"
#include "methods/flow/stop_events.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::linear_flow_test {
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
    Eigen::VectorXd rate, expected(dynamics.size());
    arc.rate(t, rate);
    const Eigen::VectorXd a = rate.tail(dynamics.size());
    dynamics.acceleration(arc.mode(), t, state.u, state.v, expected);
    worst = std::max(worst, (a - expected).lpNorm<Eigen::Infinity>());
    scale = std::max(scale, expected.lpNorm<Eigen::Infinity>());
  }
  return worst / scale;
}

// All outputs together are what each is alone, at one instant to the bit.
void expect_outputs_together(const ContactDynamics& dynamics, const LinearArc& arc) {
  const std::vector<double> times{0.3, 1.7, 40.0};
  const std::vector<Eigen::MatrixXd> outputs = arc.outputs(times, 2);
  ASSERT_EQ(outputs.size(), 3U);
  for (int order = 0; order <= 2; ++order) {
    const Eigen::MatrixXd& values = outputs[static_cast<std::size_t>(order)];
    const double scale = 1e-13 * (1.0 + values.cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      Eigen::Index row = 0;
      for (int j = 0; j < dynamics.contact_count(); ++j)
        EXPECT_NEAR(values(row++, column), arc.displacement(j, times[i], order), scale);
      for (const int j : arc.mode().active)
        EXPECT_NEAR(values(row++, column), arc.force(j, times[i], order), scale);
      EXPECT_EQ(row, values.rows());
    }
  }
  const Eigen::MatrixXd at_once = arc.outputs_at(1.7, 5);
  ASSERT_EQ(at_once.cols(), 6);
  for (int order = 0; order <= 5; ++order) {
    Eigen::Index row = 0;
    for (int j = 0; j < dynamics.contact_count(); ++j)
      EXPECT_EQ(at_once(row++, order), arc.displacement(j, 1.7, order));
    for (const int j : arc.mode().active) EXPECT_EQ(at_once(row++, order), arc.force(j, 1.7, order));
    EXPECT_EQ(row, at_once.rows());
  }
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
  const std::unique_ptr<LinearArc> motion_of_start = flow.arc();
  LinearArc& arc = *motion_of_start;
  arc.start(0.3, start);
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
      const double x = dynamics.structure().directions.col(j).dot(motion.u.col(k));
      EXPECT_NEAR(arc.displacement(j, 1.7, k), x, 1e-11 * (1.0 + motion.u.col(k).cwiseAbs().maxCoeff()));
    }
  }
  expect_outputs_together(dynamics, arc);
  // The transition matrix: two arcs differ by it, exactly, for the motion is linear.
  State moved = start;
  moved.u += 0.1 * random_state(dynamics.size()).v;
  moved.v -= 0.2 * random_state(dynamics.size()).u;
  if (dynamics.rigid()) events.hold(moved, flow.mode());
  const std::unique_ptr<LinearArc> other = flow.arc();
  other->start(0.3, moved);
  State end, other_end;
  arc.state(2.5, end);
  other->state(2.5, other_end);
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
    const auto flow = linear_flow(dynamics, dynamics.mode({false}));
    EXPECT_NE(dynamic_cast<const ExponentialFlow*>(flow.get()), nullptr);
    expect_flow(problem, {false}, FlowForm::automatic, "degenerate");
  }
}

TEST(LinearFlow, ResonanceGrowsLinearly) {
  // x'' + x = cos t from rest: x = t sin(t) / 2.
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0});
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)});
  for (const double t : {0.5, 3.0, 20.0}) EXPECT_NEAR(arc->displacement(0, t), 0.5 * t * std::sin(t), 1e-12);
}

// u of an impulse J on m x'' + d x' + k x = 0 at rest, a time s ago.
double struck(const test::ImpactOscillator& one, double impulse, double s) {
  const double decay = 0.5 * one.damping / one.mass;
  const double rate = std::sqrt(one.stiffness / one.mass - decay * decay);
  return impulse / (one.mass * rate) * std::exp(-decay * s) * std::sin(rate * s);
}

TEST(LinearFlow, AddsTheResponsesToImpulses) {
  const test::ImpactOscillator one{.mass = 2.0, .damping = 0.1, .stiffness = 3.0, .frequency = 2.2};
  const ContactDynamics dynamics(test::to_problem(one));
  const std::vector<Impulse> impulses{{.contact = 0, .time = 0.7, .value = -1.5},
                                      {.contact = 0, .time = 9.0, .value = 4.0}};
  const double expected = struck(one, -1.5, 0.7) + struck(one, 4.0, 9.0);
  for (const FlowForm form : {FlowForm::automatic, FlowForm::exponential}) {
    const State state = linear_flow(dynamics, dynamics.mode({false}), form)->response(impulses);
    EXPECT_NEAR(state.u[0], expected, 1e-13);
    const double h = 1e-5;
    const double difference = (struck(one, -1.5, 0.7 + h) + struck(one, 4.0, 9.0 + h) -
                               struck(one, -1.5, 0.7 - h) - struck(one, 4.0, 9.0 - h)) /
                              (2.0 * h);
    EXPECT_NEAR(state.v[0], difference, 1e-9);
  }
}

// Squaring the exponential of a stiff structure in its own coordinates would lose digits to motions that grow
// on their way.
TEST(LinearFlow, TheExponentialOfAStiffStructureIsThatOfItsModes) {
  const Problem problem = test::stopped_chain(8, 0.5, 1);
  for (const double stiffer : {1.0, 1e4, 1e8}) {
    Problem stiff = problem;
    stiff.edit_structure([&](Structure& s) { s.stiffness.coeffRef(0, 0) += stiffer; });
    const ContactDynamics dynamics(stiff);
    const auto modal = linear_flow(dynamics, dynamics.mode({false}));
    const auto exponential = linear_flow(dynamics, dynamics.mode({false}), FlowForm::exponential);
    ASSERT_NE(dynamic_cast<const ModalFlow*>(modal.get()), nullptr);
    ASSERT_NE(dynamic_cast<const ExponentialFlow*>(exponential.get()), nullptr);
    const Eigen::MatrixXd expected = modal->transition(5.0);
    // The phase of the fastest motion, sqrt(stiffer) t, is known to its rounding only.
    const double rounding = 1e-13 * (1.0 + 5.0 * std::sqrt(stiffer));
    EXPECT_LT((exponential->transition(5.0) - expected).norm(), rounding * expected.norm()) << stiffer;
  }
}

TEST(LinearArc, ModesBoundTheStepsUntilTheyFade) {
  const test::ImpactOscillator one{.damping = 0.2, .stiffness = 400.0, .frequency = 1.5};
  const ContactDynamics dynamics(test::to_problem(one));
  LinearFlows flows(dynamics);
  const LinearFlow& flow = flows.of({false});
  const auto forced = [&](double t) {
    const std::unique_ptr<LinearArc> arc = flow.arc();
    State steady;
    arc->start(-1e4, {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)});
    arc->state(t, steady);
    return steady;
  };
  State start = forced(0.0);
  const double share = 1e-3;  // of X, by which the free motion starts away from the steady one
  start.u[0] += share * dynamics.scales().displacement;
  const std::unique_ptr<LinearArc> motion = flow.arc();
  LinearArc& arc = *motion;
  arc.start(0.0, start);
  const double floor = 1e-9;
  const std::vector<FadingRate> terms = arc.fading_rates(floor);
  ASSERT_EQ(terms.size(), 2U);
  EXPECT_NEAR(terms[0].rate, 20.0, 1e-12);
  // share e^{-0.1 t} = floor, but for the phase of the amplitude: cos of the angle of damping, 0.005^2 / 2.
  EXPECT_NEAR(terms[0].until, std::log(share / floor) / 0.1, 1e-3);
  EXPECT_EQ(fastest_left(terms, 0.99 * terms[0].until), terms[0].rate);
  EXPECT_EQ(fastest_left(terms, 1.01 * terms[0].until), one.frequency);
  // In the step in which the load, the next slower term, turns by 0.75 the mode turns by 10: its share in the
  // fourth derivative is 10^4 times as large, and seen for longer.
  EXPECT_NEAR(arc.fading_rates(floor, 0.75, 4).front().until, std::log(1e4 * share / floor) / 0.1, 1e-3);
  // Already faded: it bounds no step at all.
  EXPECT_EQ(arc.fading_rates(1e-2).size(), 1U);
}

// A harmonic of the load matters from some size on, the fastest one that does by its rate.
TEST(LinearArc, TinyHarmonicsOfTheLoadBoundNoStep) {
  const test::ImpactOscillator one{.damping = 0.2, .stiffness = 400.0, .frequency = 1.5};
  Problem problem = test::to_problem(one);
  problem.force.push_back({.dof = 0, .harmonic = 40, .cos = 1e-5 * one.load, .sin = 0.0});
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, dynamics.at_rest());
  EXPECT_EQ(arc->fading_rates(1e-9).front().rate, 40.0 * one.frequency);
  EXPECT_EQ(arc->fading_rates(1e-3).back().rate, one.frequency);
  // In its derivatives it weighs more.
  EXPECT_EQ(arc->fading_rates(1e-3, 1.0, 4).front().rate, 40.0 * one.frequency);
}

TEST(LinearArc, UndampedModesNeverFade) {
  const ContactDynamics dynamics(test::to_problem({.damping = 0.0, .stiffness = 400.0, .frequency = 1.5}));
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, {.u = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Zero(1)});
  EXPECT_EQ(fastest_left(arc->fading_rates(1e-9), 1e9), 20.0);
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
}  // namespace signorini::linear_flow_test
