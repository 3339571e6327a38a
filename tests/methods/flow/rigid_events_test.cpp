// Events at rigid stops: what is listed of them, and the saltation matrix against differences of the flow.

#include "methods/flow/rigid_events.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "methods/flow/flow.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

FlowState at_stop(double gap, double speed) {
  return {.time = 0.0,
          .state = {.u = Eigen::VectorXd::Constant(1, gap), .v = Eigen::VectorXd::Constant(1, speed)},
          .closed = {false}};
}

TEST(RigidEvents, AnImpactIsListedWithItsImpulse) {
  const ContactDynamics dynamics(
      test::to_problem({.mass = 2.0, .frequency = 1.0, .gap = 0.3, .restitution = 0.8}));
  FlowState flow = at_stop(0.3, 1.5);
  FlowRecord record;
  RigidEvents(dynamics, 1e-9).resolve(flow, 0, record);
  EXPECT_NEAR(flow.state.v[0], -1.2, 1e-15);
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, ContactEvent::Kind::impact);
  EXPECT_NEAR(record.events[0].impulse, -2.0 * 1.8 * 1.5, 1e-14);
  ASSERT_EQ(record.sequence.size(), 1U);
  EXPECT_EQ(record.sequence[0].restitution, std::vector<double>{0.8});
}

TEST(RigidEvents, AnImpactWithoutReboundIsOneClosingWithItsImpulse) {
  // The load cos(w t) = 1 presses, the spring pulls with 0.3: the mass sticks.
  const ContactDynamics dynamics(test::to_problem({.frequency = 1.0, .gap = 0.3, .restitution = 0.0}));
  FlowState flow = at_stop(0.3, 1.5);
  FlowRecord record;
  RigidEvents(dynamics, 1e-9).resolve(flow, 0, record);
  EXPECT_TRUE(flow.closed[0]);
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, ContactEvent::Kind::close);
  EXPECT_NEAR(record.events[0].impulse, -1.5, 1e-15);
}

TEST(RigidEvents, TheEndOfAChatterIsAnImpactAndAClosingAtTheLimit) {
  const double e = 0.5, v = 1e-7;
  const ContactDynamics dynamics(test::to_problem({.frequency = 1.0, .gap = 0.3, .restitution = e}));
  FlowState flow = at_stop(0.3, v);
  FlowRecord record;
  RigidEvents(dynamics, 1e-6).resolve(flow, 0, record);
  EXPECT_TRUE(flow.closed[0]);
  ASSERT_EQ(record.events.size(), 2U);
  EXPECT_EQ(record.events[0].kind, ContactEvent::Kind::impact);
  EXPECT_NEAR(record.events[0].impulse, -v, 1e-6 * v);  // the whole momentum
  EXPECT_EQ(record.events[1].kind, ContactEvent::Kind::close);
  EXPECT_EQ(record.events[1].impulse, 0.0);
  const double a = 1.0 - 0.3;  // x'' towards the stop
  EXPECT_NEAR(record.events[1].time, 2.0 * e * v / (a * (1.0 - e)), 1e-3 * v);
}

TEST(RigidEvents, HoldAndExpelMoveContactsToTheirStopsInTheMetricOfTheMass) {
  const ContactDynamics dynamics(test::stopped_chain(4, 0.5, 2));
  const FlowStructure& structure = dynamics.structure();
  const RigidEvents events(dynamics, 1e-9);
  State state{.u = Eigen::VectorXd::LinSpaced(4, 0.1, 3.0), .v = Eigen::VectorXd::Ones(4)};
  const State before = state;
  const ContactMode mode = dynamics.mode({true, true});
  events.hold(state, mode);
  EXPECT_LT((structure.directions.transpose() * state.u - structure.gaps).norm(), 1e-14);
  EXPECT_LT((structure.directions.transpose() * state.v).norm(), 1e-14);
  // The nearest state in the metric of M: M (u - before) is normal to all that the stops admit.
  const Eigen::MatrixXd Q = dynamics.stops().free_form(mode).basis;
  EXPECT_LT((Q.transpose() * (structure.mass * (state.u - before.u))).norm(), 1e-13);
  EXPECT_LT((Q.transpose() * (structure.mass * (state.v - before.v))).norm(), 1e-13);

  State inside = before;
  events.expel(inside);
  const Eigen::VectorXd gap = structure.gaps - structure.directions.transpose() * inside.u;
  EXPECT_GT(gap.minCoeff(), -1e-14);
}

// The derivative of the flow through an impact and a sticking phase, saltation included.
TEST(RigidEvents, SaltationIsTheDerivativeOfTheFlow) {
  for (const double e : {0.7, 0.0}) {
    const ContactDynamics dynamics(test::stopped_chain(3, e, 1));
    const auto never = [] { return false; };
    EventFlow flow(dynamics, 1e-12, never, Integrator::modal);
    const auto mapped = [&](const Eigen::VectorXd& y, FlowRecord& record) {
      FlowState state = flow.place(0.0, {.u = y.head(3), .v = y.tail(3)});
      flow.advance(state, 4.0, record);
      Eigen::VectorXd end(6);
      end << state.state.u, state.state.v;
      return end;
    };
    Eigen::VectorXd y(6);
    y << 0.0, 0.1, 0.05, 0.2, 0.6, 1.0;
    FlowRecord kept;
    kept.tangent = true;
    mapped(y, kept);
    ASSERT_FALSE(kept.events.empty()) << e;
    for (int column = 0; column < 6; ++column) {
      constexpr double kStep = 1e-6;
      FlowRecord a, b;
      const Eigen::VectorXd h = kStep * Eigen::VectorXd::Unit(6, column);
      const Eigen::VectorXd difference = (mapped(y + h, a) - mapped(y - h, b)) / (2.0 * kStep);
      EXPECT_LT((difference - kept.derivative.col(column)).norm(), 1e-6 * (1.0 + difference.norm()))
          << "e = " << e << ", column " << column;
    }
  }
}

}  // namespace
}  // namespace signorini
