// Damped massless contacts at their stops: which push, and what a closing does to the others.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <random>
#include <vector>

#include "methods/flow/flow.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "tests/support/relaxing_scenes.hpp"

namespace signorini::relaxing_events_test {
namespace {

const auto kNever = [] { return false; };

// Springs between any two of `count` coordinates, the first `masses` of 1 kg, D = 0.1 / s M + beta K.
struct Springs {
  explicit Springs(int count) : K(Eigen::MatrixXd::Zero(count, count)) {}
  Springs& to_wall(int i, double spring) {
    K(i, i) += spring;
    return *this;
  }
  Springs& tie(int i, int j, double spring) {
    K(i, i) += spring;
    K(j, j) += spring;
    K(i, j) -= spring;
    K(j, i) -= spring;
    return *this;
  }
  [[nodiscard]] Problem problem(int masses, double beta) const {
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(K.rows());
    mass.head(masses).setOnes();
    Problem result;
    result.edit_structure([&](Structure& s) {
      s.mass = Eigen::MatrixXd(mass.asDiagonal()).sparseView();
      s.stiffness = K.sparseView();
      s.damping = SparseMatrix(0.1 * s.mass) + SparseMatrix(beta * s.stiffness);
    });
    result.set_law(Massless{});
    return result;
  }
  Eigen::MatrixXd K;
};

// u = 0 and contacts at their stops, with the speeds a that they would have without forces.
State at_stops(const ContactDynamics& dynamics, double time, const Eigen::VectorXd& a) {
  const FlowStructure& s = dynamics.structure();
  State state = dynamics.at_rest();
  state.u.tail(s.contact_count()) = s.gaps;
  const Eigen::VectorXd relaxed = (s.shift_at(time, 0) - s.gaps).cwiseQuotient(s.relaxation);
  state.v = least_norm_solve(s.directions.transpose(), Eigen::VectorXd(a - relaxed));
  return state;
}

// Of any set A of contacts and p_A > 0 the speeds a = C p / beta - w without forces, w > 0 off A, have that
// set for their answer, and no other.
TEST(RelaxingEvents, ContactsThatPushAreTheAdmissibleSet) {
  const ContactDynamics dynamics(test::damped_coupled_scene(1, 0.3));
  const FlowStructure& structure = dynamics.structure();
  const GivingEvents events(dynamics, 1e-9);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> draw(0.1, 1.0);
  for (unsigned trial = 0; trial < 200; ++trial) {
    Eigen::Vector3d push = Eigen::Vector3d::Zero(), leaving = push;
    std::vector<bool> expected(3);
    for (int j = 0; j < 3; ++j) {
      expected[static_cast<std::size_t>(j)] = ((trial >> j) & 1U) != 0;
      (expected[static_cast<std::size_t>(j)] ? push : leaving)[j] = draw(generator);
    }
    const Eigen::Vector3d a = structure.massless_compliance * push / structure.relaxation[0] - leaving;
    EXPECT_EQ(events.place(0.4, at_stops(dynamics, 0.4, a)).closed, expected) << trial;
  }
}

TEST(RelaxingEvents, PlacingMovesPenetratingContactsBackAndNoOthers) {
  const ContactDynamics dynamics(Springs(2).to_wall(0, 1.0).tie(0, 1, 4.0).problem(1, 0.2));
  EXPECT_EQ(dynamics.structure().relaxing(), 0);  // no contact: nothing to relax
  Problem problem = Springs(3).to_wall(0, 1.0).tie(0, 1, 4.0).tie(0, 2, 5.0).problem(1, 0.2);
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 0.1}, {.normal = {{2, 1.0}}, .gap = 0.3}};
  const ContactDynamics pair(problem);
  State state = pair.at_rest();
  state.u << 0.0, 0.5, 0.2;  // u; xi
  const FlowState placed = GivingEvents(pair, 1e-9).place(0.0, state);
  EXPECT_NEAR(placed.state.u[1], 0.1, 1e-15);
  EXPECT_EQ(placed.state.u[2], 0.2);  // the nodes do not feel each other
  EXPECT_EQ(placed.state.u[0], 0.0);
}

TEST(RelaxingEvents, AClosingStopsTheContactWithAStepOfForceAndNoImpulse) {
  for (const double dashpot : {0.5, 0.05}) {
    const ContactDynamics dynamics(test::damped_tip_chain(dashpot));
    for (const Integrator integrator : {Integrator::modal, Integrator::cvode}) {
      EventFlow flow(dynamics, 1e-11, kNever, integrator);
      FlowState state = flow.place(0.0, dynamics.at_rest());
      FlowRecord record;
      record.dense = true;
      flow.advance(state, 4.0 * dynamics.structure().forcing_period, record);
      int closings = 0;
      for (std::size_t i = 1; i < record.nodes.size(); ++i) {
        const FlowNode &left = record.nodes[i - 1], &right = record.nodes[i];
        if (left.time != right.time || !(left.x(0, 1) > 1e-6)) continue;
        ++closings;
        EXPECT_NEAR(right.x(0, 0), left.x(0, 0), 1e-12);
        EXPECT_NEAR(right.x(0, 1), 0.0, 1e-12);
        EXPECT_EQ(left.lambda(0, 0), 0.0);
        EXPECT_NEAR(right.lambda(0, 0), -dashpot * left.x(0, 1), 1e-12);
      }
      EXPECT_GE(closings, 3);
      for (const ContactEvent& event : record.events) EXPECT_EQ(event.impulse, 0.0);
    }
  }
}

TEST(RelaxingEvents, AClosingMayOpenAnotherContactAtTheSameInstant) {
  Problem problem =
      Springs(4).to_wall(0, 1.0).to_wall(1, 1.0).tie(0, 2, 4.0).tie(1, 3, 4.0).tie(2, 3, 3.0).problem(2, 0.2);
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.1}, {.normal = {{3, 1.0}}, .gap = 0.1}};
  const ContactDynamics dynamics(problem);
  ASSERT_GT(dynamics.structure().massless_compliance(0, 1), 0.0);
  const GivingEvents events(dynamics, 1e-9);
  for (const double slow : {0.01, 0.9}) {
    FlowState flow{
        .time = 0.2, .state = at_stops(dynamics, 0.2, Eigen::Vector2d(slow, 1.0)), .closed = {true, false}};
    const State before = flow.state;
    FlowRecord record;
    events.resolve(flow, 1, record);
    const bool stays = slow > 0.5;
    EXPECT_EQ(flow.closed, (std::vector<bool>{stays, true}));
    EXPECT_EQ(record.events.size(), stays ? 1U : 2U);
    ASSERT_EQ(record.sequence.size(), 1U);
    EXPECT_EQ(record.sequence[0].contact, 1);
    EXPECT_EQ(record.sequence[0].kind, ContactEvent::Kind::close);
    EXPECT_LT((flow.state.u - before.u).norm() + (flow.state.v - before.v).norm(), 1e-15);
  }
}

// Seven nodes in a ring around one mass close and open together: they are one node behind seven springs. An
// eighth contact is the first once more: G is singular, and only the share of the force undecided.
TEST(RelaxingEvents, EqualContactsCloseAndOpenTogether) {
  constexpr int kNodes = 7;
  Springs ring(1 + kNodes), one(2);
  ring.to_wall(0, 1.0);
  one.to_wall(0, 1.0).tie(0, 1, kNodes * 4.0);
  for (int j = 0; j < kNodes; ++j) ring.tie(0, 1 + j, 4.0).tie(1 + j, 1 + (j + 1) % kNodes, 2.0);
  Problem many = ring.problem(1, 0.1), single = one.problem(1, 0.1);
  for (Problem* problem : {&many, &single}) {
    problem->frequency = 1.3;
    problem->force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  }
  for (int j = 0; j < kNodes; ++j) many.contacts.push_back({.normal = {{1 + j, 1.0}}, .gap = 0.2});
  single.contacts = {{.normal = {{1, 1.0}}, .gap = 0.2}};
  Problem twice = many;
  twice.contacts.push_back(many.contacts[0]);
  const ContactDynamics alone(single);
  EventFlow reference(alone, 1e-11, kNever, Integrator::modal);
  for (const Problem* problem : {&many, &twice}) {
    const ContactDynamics dynamics(*problem);
    for (const Integrator integrator : {Integrator::modal, Integrator::cvode}) {
      EventFlow flow(dynamics, 1e-11, kNever, integrator);
      FlowState state = flow.place(0.0, dynamics.at_rest()), expected = reference.place(0.0, alone.at_rest());
      FlowRecord record, alone_record;
      flow.advance(state, 20.0, record);
      reference.advance(expected, 20.0, alone_record);
      ASSERT_GE(alone_record.events.size(), 6U);
      if (problem == &many) {
        EXPECT_EQ(record.events.size(), alone_record.events.size() * many.contacts.size());
      }
      EXPECT_EQ(record.sequence.size(), alone_record.sequence.size());
      EXPECT_NEAR(state.state.u[0], expected.state.u[0], 1e-9);
      EXPECT_NEAR(state.state.v[0], expected.state.v[0], 1e-9);
      EXPECT_NEAR(state.state.u[1], expected.state.u[1], 1e-9);
    }
  }
}

// The derivative of the flow through closings and openings, by differences, and beside a rigid stop through
// impacts while a damped one is pushed.
TEST(RelaxingEvents, SaltationIsTheDerivativeOfTheFlow) {
  Problem beside_rigid = test::damped_coupled_scene(1, 0.2);
  beside_rigid.contacts.push_back({.normal = {{0, 1.0}}, .gap = 0.25, .law = Restitution{0.7}});
  for (const Problem& problem : {test::damped_coupled_scene(1, 0.2), beside_rigid}) {
    const ContactDynamics dynamics(problem);
    const int states = dynamics.states(), p = dynamics.positions();
    for (const Integrator integrator : {Integrator::modal, Integrator::cvode}) {
      EventFlow flow(dynamics, 1e-12, kNever, integrator);
      FlowState start = flow.place(0.0, dynamics.at_rest());
      FlowRecord ignored;
      flow.advance(start, 3.0, ignored);
      while (std::find(start.closed.begin(), start.closed.end(), true) != start.closed.end())
        flow.advance(start, 0.05, ignored);
      FlowRecord record;
      record.tangent = true;
      FlowState end = start;
      flow.advance(end, 6.0, record);
      ASSERT_GE(record.events.size(), 2U);
      constexpr double kStep = 1e-6;
      for (int i = 0; i < states; ++i) {
        if (i >= dynamics.size() && i < p && dynamics.rigid(i - dynamics.size()))
          continue;  // gives way never
        const auto moved = [&](double step) {
          FlowState other = start;
          (i < p ? other.state.u[i] : other.state.v[i - p]) += step;
          FlowRecord none;
          flow.advance(other, 6.0, none);
          Eigen::VectorXd y(states);
          y << other.state.u, other.state.v;
          return y;
        };
        const Eigen::VectorXd slope = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
        EXPECT_LT((slope - record.derivative.col(i)).norm(), 1e-5 * (1.0 + slope.norm())) << i;
      }
    }
  }
}

// A constant load that keeps the tip on its stop: the state stays on the stop, and the force goes to the
// static one.
TEST(RelaxingEvents, AConstantLoadKeepsTheContactWhereItsStopIs) {
  Problem problem = test::damped_tip_chain(0.5);
  problem.force = {{.dof = 2, .harmonic = 0, .cos = 3.0, .sin = 0.0}};
  const ContactDynamics dynamics(problem);
  const Eigen::MatrixXd K = problem.stiffness();
  const Eigen::VectorXd u = lu_solve(K, Eigen::VectorXd(Eigen::Vector4d(0.0, 0.0, 3.0, 0.0)));
  const Eigen::MatrixXd C = LuFactors(K).inverse();
  for (const Integrator integrator : {Integrator::modal, Integrator::cvode}) {
    EventFlow flow(dynamics, 1e-11, kNever, integrator);
    FlowState state = flow.place(0.0, dynamics.at_rest());
    FlowRecord record;
    flow.advance(state, 2000.0, record);
    EXPECT_TRUE(state.closed[0]);
    const MotionDerivatives motion =
        dynamics.derivatives(dynamics.mode(state.closed), state.time, state.state, 2);
    EXPECT_NEAR(motion.x(0, 0), 0.2, 1e-14);
    EXPECT_NEAR(motion.lambda(0, 0), -(u[3] - 0.2) / C(3, 3), 1e-9);
  }
}

}  // namespace
}  // namespace signorini::relaxing_events_test
