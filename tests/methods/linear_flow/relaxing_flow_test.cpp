// Motion with damped massless contacts between events, against the flow of the whole structure's coordinates.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <memory>
#include <random>
#include <vector>

#include "methods/flow/stop_events.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "tests/support/relaxing_scenes.hpp"

namespace signorini::relaxing_flow_test {
namespace {

constexpr double kStart = 0.3;

// A state on the stops of a mode.
State admissible_state(const ContactDynamics& dynamics, const ContactMode& mode, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, 0.3);
  State state = dynamics.at_rest();
  for (double& u : state.u) u = normal(generator);
  for (double& v : state.v) v = normal(generator);
  GivingEvents(dynamics, 1e-12).hold(state, mode);
  return state;
}

Eigen::VectorXd stacked(const State& state) {
  Eigen::VectorXd y(state.u.size() + state.v.size());
  y << state.u, state.v;
  return y;
}

std::vector<std::vector<bool>> all_sets(int contacts) {
  std::vector<std::vector<bool>> sets;
  for (unsigned bits = 0; bits < (1U << contacts); ++bits) {
    std::vector<bool> closed;
    for (int j = 0; j < contacts; ++j) closed.push_back(((bits >> j) & 1U) != 0);
    sets.push_back(closed);
  }
  return sets;
}

void expect_descriptor_flow(const Problem& problem, double tolerance) {
  const ContactDynamics dynamics(problem);
  const test::DescriptorFlow whole(problem);
  ASSERT_EQ(dynamics.states(), whole.size());
  for (const FlowForm form : {FlowForm::automatic, FlowForm::exponential}) {
    LinearFlows flows(dynamics, form);
    for (const std::vector<bool>& closed : all_sets(dynamics.contact_count())) {
      const LinearFlow& flow = flows.of(closed);
      const ContactMode& mode = flow.mode();
      const State start = admissible_state(dynamics, mode, 5);
      const auto arc = flow.arc();
      arc->start(kStart, start);
      const Eigen::VectorXd x = dynamics.structure().unloaded(kStart, start.u, 0);
      const Eigen::VectorXd first = whole.state(start.u, start.v, x);
      for (const double duration : {0.0, 0.04, 0.5, 3.0}) {
        const double t = kStart + duration;
        const Eigen::VectorXd y = whole.after(mode.active, kStart, first, duration);
        const Eigen::VectorXd moved = whole.displacement() * y, pushed = whole.force(mode.active, t, y),
                              rate = whole.displacement() * whole.rate(mode.active, t, y);
        for (int j = 0; j < dynamics.contact_count(); ++j) {
          EXPECT_NEAR(arc->displacement(j, t), moved[j], tolerance) << "contact " << j << ", t = " << t;
          EXPECT_NEAR(arc->displacement(j, t, 1), rate[j], 10.0 * tolerance);
          EXPECT_NEAR(arc->force(j, t), pushed[j], tolerance * (1.0 + pushed.cwiseAbs().maxCoeff()));
        }
      }
    }
  }
}

TEST(RelaxingFlow, IsThatOfTheWholeStructure) {
  expect_descriptor_flow(test::rayleigh_chain(), 1e-13);
  expect_descriptor_flow(test::damped_tip_chain(0.5), 1e-13);
  expect_descriptor_flow(test::damped_tip_chain(0.01), 1e-13);
  for (unsigned seed = 1; seed <= 3; ++seed)
    expect_descriptor_flow(test::damped_coupled_scene(seed, 0.2), 2e-12);
}

TEST(RelaxingFlow, RatesDerivativesAndTransitionsAreThoseOfTheMotion) {
  const ContactDynamics dynamics(test::damped_coupled_scene(2, 0.2));
  for (const FlowForm form : {FlowForm::automatic, FlowForm::exponential}) {
    LinearFlows flows(dynamics, form);
    for (const std::vector<bool>& closed : all_sets(3)) {
      const LinearFlow& flow = flows.of(closed);
      const State start = admissible_state(dynamics, flow.mode(), 6),
                  other = admissible_state(dynamics, flow.mode(), 7);
      const auto arc = flow.arc(), moved = flow.arc();
      arc->start(kStart, start);
      moved->start(kStart, other);
      State now, then;
      arc->state(1.1, now);
      Eigen::VectorXd rate, expected(dynamics.states());
      arc->rate(1.1, rate);
      dynamics.rate(flow.mode(), 1.1, stacked(now), expected);
      EXPECT_LT((rate - expected).norm(), 1e-11 * (1.0 + expected.norm()));
      const MotionDerivatives motion = dynamics.derivatives(flow.mode(), 1.1, now, 7);
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k <= 5; ++k) {
          EXPECT_NEAR(arc->displacement(j, 1.1, k), motion.x(j, k), 1e-10 * (1.0 + motion.x.col(k).norm()));
          EXPECT_NEAR(arc->force(j, 1.1, k), motion.lambda(j, k), 1e-9 * (1.0 + motion.lambda.col(k).norm()));
        }
      }
      moved->state(1.1, then);
      const Eigen::VectorXd before = stacked(other) - stacked(start), after = stacked(then) - stacked(now);
      EXPECT_LT((flow.transition(1.1 - kStart) * before - after).norm(), 1e-12 * (1.0 + after.norm()));
      const Eigen::MatrixXd grown = matrix_exponential(dynamics.flow_matrix(flow.mode()) * (1.1 - kStart));
      EXPECT_LT((grown * before - after).norm(), 1e-11 * (1.0 + after.norm()));
      const TransitionFactors factors = flow.transition_factors(1.1 - kStart);
      EXPECT_LT((factors.writing * (factors.reading * before) - after).norm(), 1e-12 * (1.0 + after.norm()));
    }
  }
}

// What an impulse leaves behind is the limit of a short, strong force on the whole structure: an impulse p
// moves u_b by D_bb^-1 W_b p at once.
TEST(RelaxingFlow, RespondsToImpulsesAsTheWholeStructure) {
  Problem problem = test::damped_coupled_scene(1, 0.2);
  problem.force.clear();
  const ContactDynamics dynamics(problem);
  const test::DescriptorFlow whole(problem);
  for (const FlowForm form : {FlowForm::automatic, FlowForm::exponential}) {
    LinearFlows flows(dynamics, form);
    const State struck =
        flows.of({false, false, false}).response({{.contact = 1, .time = 0.7, .value = -0.4}});
    const Eigen::VectorXd first = -0.4 * whole.impulse(1);
    const Eigen::VectorXd y = whole.after({}, 0.0, first, 0.7);
    EXPECT_LT((dynamics.structure().unloaded(0.0, struck.u, 0) - whole.displacement() * y).norm(), 1e-13);
    EXPECT_LT((struck.v - y.segment(4, 4)).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace signorini::relaxing_flow_test
