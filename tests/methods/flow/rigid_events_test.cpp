// Newton's law for several contacts; events at rigid stops: what is listed of them, and the saltation matrix
// against differences of the flow.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "methods/flow/flow.hpp"
#include "methods/flow/stop_events.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::rigid_events_test {
namespace {

// Rows that differ by rounding alone share the force, whatever the solution of a nearly singular system is.
TEST(NewtonImpulses, OfTheSameStopTwiceGiveTheVelocityOfTheStopOnce) {
  for (const double apart : {0.0, 1e-16, 1e-13, 1e-10}) {
    Eigen::Matrix2d G = Eigen::Matrix2d::Constant(0.5);
    G(0, 1) = G(1, 0) = 0.5 * (1.0 - apart);
    const auto p = newton_impulses(G, Eigen::Vector2d(2.0, 2.0), Eigen::Vector2d(0.5, 0.5));
    ASSERT_TRUE(p) << apart;
    EXPECT_LE(p->maxCoeff(), 0.0);
    const Eigen::Vector2d after = Eigen::Vector2d(2.0, 2.0) + G * *p;
    EXPECT_NEAR(after[0], -1.0, 1e-9);
    EXPECT_NEAR(after[1], -1.0, 1e-9);
    EXPECT_NEAR(p->sum(), -6.0, 1e-8);
  }
}

TEST(NewtonImpulses, ReproduceTheSingleContact) {
  const auto p = newton_impulses(Eigen::MatrixXd::Constant(1, 1, 0.5), Eigen::VectorXd::Constant(1, 3.0),
                                 Eigen::VectorXd::Constant(1, 0.8));
  ASSERT_TRUE(p);
  EXPECT_NEAR((*p)[0], -1.8 * 3.0 / 0.5, 1e-14 * 10.8);
}

TEST(NewtonImpulses, PassAnImpulseOnToARestingContactThatItPushes) {
  // Off-diagonal < 0: an impulse at contact 0 drives contact 1 into its stop.
  const Eigen::MatrixXd G = (Eigen::Matrix2d() << 2.0, -1.0, -1.0, 2.0).finished();
  const auto p = newton_impulses(G, Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.5, 0.5));
  ASSERT_TRUE(p);
  const Eigen::Vector2d after = Eigen::Vector2d(1.0, 0.0) + G * *p;
  EXPECT_NEAR(after[0], -0.5, 1e-14);
  EXPECT_NEAR(after[1], 0.0, 1e-14);
  EXPECT_LT((*p)[1], 0.0);
}

TEST(NewtonImpulses, LeaveARestingContactAloneThatTheImpactLiftsOff) {
  const Eigen::MatrixXd G = (Eigen::Matrix2d() << 2.0, 1.0, 1.0, 2.0).finished();
  const auto p = newton_impulses(G, Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.5, 0.5));
  ASSERT_TRUE(p);
  EXPECT_DOUBLE_EQ((*p)[1], 0.0);
  EXPECT_LT(G(1, 0) * (*p)[0], 0.0);
}

TEST(NewtonImpulses, NeverGainEnergyAndNeverPull) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index size = 2 + trial % 4;
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    const Eigen::MatrixXd G = B * B.transpose() + 0.2 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(size, [&] { return std::abs(normal(random)); });
    const Eigen::VectorXd e = Eigen::VectorXd::Constant(size, unit(random));
    const auto p = newton_impulses(G, v, e);
    ASSERT_TRUE(p);
    EXPECT_LE(p->maxCoeff(), 0.0);
    const Eigen::VectorXd after = v + G * *p;
    // Work of the impulses: p . (v_- + v_+) / 2.
    EXPECT_LE(p->dot(v + after), 1e-12 * v.squaredNorm() / G.diagonal().minCoeff());
    EXPECT_LE((after + e.cwiseProduct(v)).maxCoeff(), 1e-10 * v.maxCoeff());
  }
}

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

// Two masses that reach their stops at one instant, side by side or coupled by the mass matrix.
TEST(RigidEvents, ImpactsOfOneInstantAreOneEventEachUnlessTheMassCouplesThem) {
  for (const double coupling : {0.0, 0.5}) {
    Problem problem = test::stopped_chain(2, 0.8, 2);
    problem.edit_structure([coupling](Structure& structure) {
      structure.mass = Eigen::Matrix2d{{1.0, coupling}, {coupling, 1.0}}.sparseView();
      structure.damping = SparseMatrix(2, 2);  // a damper between them would make their order matter, too
    });
    const ContactDynamics dynamics(problem);
    FlowState flow{.time = 0.0,
                   .state = {.u = dynamics.structure().gaps, .v = Eigen::Vector2d(1.0, 2.0)},
                   .closed = {false, false}};
    FlowRecord record;
    record.tangent = true;
    record.derivative = Eigen::MatrixXd::Identity(4, 4);
    RigidEvents(dynamics, 1e-9).resolve(flow, 1, record);
    EXPECT_EQ(record.events.size(), 2U);
    EXPECT_EQ(record.order_matters, coupling != 0.0);
    ASSERT_EQ(record.sequence.size(), coupling == 0.0 ? 2U : 1U);
    if (coupling != 0.0) {
      EXPECT_EQ(record.sequence[0].pushed, (std::vector<int>{0, 1}));
      continue;
    }
    EXPECT_EQ(record.sequence[0].contact, 0);
    EXPECT_EQ(record.sequence[1].contact, 1);
    EXPECT_EQ(record.sequence[1].pushed, std::vector<int>{1});
    // Of each mass by itself: det = e^2.
    EXPECT_NEAR(record.derivative.determinant(), 0.8 * 0.8 * 0.8 * 0.8, 1e-12);
  }
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

TEST(RigidEvents, HoldAndPlaceMoveContactsToTheirStopsInTheMetricOfTheMass) {
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

  const State inside = events.place(0.0, before).state;
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
}  // namespace signorini::rigid_events_test
