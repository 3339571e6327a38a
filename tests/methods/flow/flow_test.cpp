#include "methods/flow/flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "methods/periodic_motion/period_map.hpp"
#include "tests/methods/event_driven/scenes.hpp"

namespace signorini::flow_test {
namespace {

using test::ImpactOscillator;
using test::to_problem;
using test::two_masses;

const std::function<bool()> kNever = [] { return false; };

Eigen::VectorXd one(double value) { return Eigen::VectorXd::Constant(1, value); }

Eigen::VectorXd packed(const State& state) {
  Eigen::VectorXd y(2 * state.u.size());
  y << state.u, state.v;
  return y;
}

FlowRecord flow_of(const Problem& problem, const State& start, double duration, FlowState& end,
                   bool tangent = false) {
  const ContactDynamics dynamics(problem);
  EventFlow flow(dynamics, 1e-11, kNever);
  FlowRecord record;
  record.tangent = tangent;
  end = flow.place(0.0, start);
  flow.advance(end, duration, record);
  return record;
}

// Undamped mass without stiffness would be simpler still, but k > 0 keeps the general path: x = cos t.
TEST(EventFlow, ReflectsAFreeOscillationAtTheStop) {
  ImpactOscillator o{.damping = 0.0, .load = 0.0, .gap = 0.5, .restitution = 0.6};
  FlowState end;
  const FlowRecord record = flow_of(to_problem(o), {.u = one(-1.0), .v = one(0.0)}, 4.0, end);
  ASSERT_GE(record.events.size(), 1U);
  const double hit = std::numbers::pi - std::acos(0.5);  // -cos t = 0.5
  const double speed = std::sin(hit);
  EXPECT_NEAR(record.events[0].time, hit, 1e-11);
  EXPECT_NEAR(record.events[0].impulse, -1.6 * speed, 2e-11);
  const double s = 4.0 - hit;
  EXPECT_NEAR(end.state.u[0], 0.5 * std::cos(s) - 0.6 * speed * std::sin(s), 1e-10);
}

TEST(EventFlow, NeitherMissesNorLoopsOnAGraze) {
  // x = -cos t from rest at -1 peaks at 1: stops just beyond and just short of the peak.
  for (const double beyond : {1e-6, 1e-9, -1e-9, -1e-6}) {
    const ImpactOscillator o{.damping = 0.0, .load = 0.0, .gap = 1.0 + beyond, .restitution = 0.8};
    FlowState end;
    const FlowRecord record = flow_of(to_problem(o), {.u = one(-1.0), .v = one(0.0)}, 5.0, end);
    if (beyond > 0.0) {
      EXPECT_TRUE(record.events.empty()) << beyond;
    } else {
      ASSERT_EQ(record.events.size(), 1U) << beyond;
      // v^2 = 1 - g^2.
      EXPECT_NEAR(-record.events[0].impulse / (1.0 + o.restitution), std::sqrt(1.0 - o.gap * o.gap),
                  3e-6 * std::sqrt(1e-9 / -beyond));
    }
    EXPECT_NEAR(end.state.u[0], -std::cos(5.0), 4.0 * std::sqrt(std::abs(beyond)));
  }
}

TEST(EventFlow, CarriesAChatterToItsLimit) {
  // A heavy ball: k tiny, constant load a = 1 towards the stop at 0 from x = -1/2: first impact at t = 1, v =
  // 1, then flights of 2 e^k: all over at 1 + 2 e / (1 - e).
  for (const double e : {0.3, 0.5, 0.9}) {
    ImpactOscillator o{
        .damping = 0.0, .stiffness = 1e-12, .load = 0.0, .gap = 0.0, .restitution = e, .static_load = 1.0};
    const double limit = 1.0 + 2.0 * e / (1.0 - e);
    FlowState end;
    const FlowRecord record = flow_of(to_problem(o), {.u = one(-0.5), .v = one(0.0)}, limit + 3.0, end);
    ASSERT_GE(record.events.size(), 3U);
    const auto last = record.events.size() - 1;
    EXPECT_EQ(record.events[last].kind, ContactEvent::Kind::close);
    EXPECT_EQ(record.events[last].impulse, 0.0);
    EXPECT_NEAR(record.events.back().time, limit, 2e-9) << e;
    // Each impact is e times as fast as the one before it.
    for (std::size_t k = 1; k < last; ++k) {  // the last one takes all that is left
      const double factor = k + 1 < last ? 1.0 : 1.0 / (1.0 + e);
      EXPECT_NEAR(record.events[k].impulse / record.events[k - 1].impulse, e * factor, 1e-4) << k;
      EXPECT_EQ(record.events[k].kind, ContactEvent::Kind::impact);
    }
    // The momentum delivered is that of the load until then, whatever was cut off.
    double impulse = 0.0;
    for (const ContactEvent& event : record.events) impulse += event.impulse;
    EXPECT_NEAR(impulse, -limit, 1e-4);
    EXPECT_DOUBLE_EQ(end.state.u[0], 0.0);
    EXPECT_DOUBLE_EQ(end.state.v[0], 0.0);
    EXPECT_TRUE(end.closed[0]);
  }
}

TEST(EventFlow, ElasticImpactsThatDampingTakesAwayEndInContact) {
  // A ball with drag, k tiny: flights of speed v lose (2/3) c v^2 / a, so that their height v^2 / (2 a) falls
  // like exp(-2 c t / 3), once they are short. Without drag the ball bounces for ever.
  constexpr double kDrag = 2.0;
  ImpactOscillator o{
      .damping = kDrag, .stiffness = 1e-12, .load = 0.0, .gap = 0.0, .restitution = 1.0, .static_load = 1.0};
  const State low{.u = one(-1e-4), .v = one(0.0)};
  const Problem problem = to_problem(o);
  const double limit = kFadedHeight * ContactDynamics(problem).scales().displacement;
  const double expected = std::log(1e-4 / limit) / (2.0 / 3.0 * kDrag);
  FlowState end;
  ASSERT_GT(expected, 0.0);
  const FlowRecord record = flow_of(problem, low, expected + 1.0, end);
  ASSERT_FALSE(record.events.empty());
  EXPECT_EQ(record.events.back().kind, ContactEvent::Kind::close);
  EXPECT_NEAR(record.events.back().time, expected, 0.02 * expected);
  EXPECT_TRUE(end.closed[0]);
  o.damping = 0.0;
  flow_of(to_problem(o), low, 3.0, end);
  EXPECT_FALSE(end.closed[0]);
}

TEST(EventFlow, ReleasesAStickingContactWhenItsForceVanishes) {
  // lambda = k g - F cos(w t) < 0 until cos(w t) = g.
  const ImpactOscillator o{.frequency = 0.5, .gap = 0.2, .restitution = 0.0};
  FlowState end;
  const FlowRecord record = flow_of(to_problem(o), {.u = one(0.2), .v = one(0.0)}, 4.0, end);
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, ContactEvent::Kind::open);
  EXPECT_NEAR(record.events[0].time, std::acos(0.2) / 0.5, 1e-12);
}

TEST(EventFlow, PutsAPenetratingStateBackBeforeTheStop) {
  const Problem problem = two_masses(1.0, 0.5);
  const ContactDynamics dynamics(problem);
  const EventFlow flow(dynamics, 1e-9, kNever);
  const FlowState placed = flow.place(0.0, {.u = Eigen::Vector2d(0.1, 0.7), .v = Eigen::Vector2d(0.0, 0.3)});
  EXPECT_NEAR(placed.state.u[1], 0.5, 1e-15);
  EXPECT_NEAR(placed.state.u[0], 0.1, 1e-15);
  EXPECT_NEAR(placed.state.v[1], -0.15, 1e-15);  // and it rebounds
}

TEST(EventFlow, HoldsAMassClampedBetweenTwoStopsOfNoGap) {
  Problem problem = to_problem(ImpactOscillator{.frequency = 1.3, .gap = 0.0, .restitution = 0.5});
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.0, .law = problem.contacts.front().law});
  FlowState end;
  const FlowRecord record =
      flow_of(problem, {.u = one(0.0), .v = one(0.0)}, 2.0 * std::numbers::pi / 1.3, end);
  EXPECT_LT(std::abs(end.state.u[0]), 1e-12);
  EXPECT_LT(std::abs(end.state.v[0]), 1e-12);
  // The force changes sides when the load changes sign, twice a period.
  int closings = 0;
  for (const ContactEvent& event : record.events) closings += event.kind == ContactEvent::Kind::close ? 1 : 0;
  EXPECT_EQ(closings, 2);
}

TEST(EventFlow, TreatsContactsThatCloseTogetherTogether) {
  // Two equal oscillators side by side hit at the same instant; so does the pair in one scene with both
  // contacts.
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
    s.stiffness = Eigen::MatrixXd((Eigen::Matrix2d() << 2.0, -1.0, -1.0, 2.0).finished()).sparseView();
    s.damping = Eigen::MatrixXd(0.1 * Eigen::Matrix2d::Identity()).sparseView();
  });
  problem.frequency = 1.0;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0},
                   {.dof = 1, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.3}, {.normal = {{1, 1.0}}, .gap = 0.3}};
  problem.set_law(Restitution{0.7});
  FlowState end;
  const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
  const FlowRecord record = flow_of(problem, {.u = zero, .v = zero}, 6.0, end);
  FlowState alone;
  const ImpactOscillator o{
      .frequency = 1.0, .gap = 0.3, .restitution = 0.7};  // in phase: springs between them rest
  const FlowRecord reference = flow_of(to_problem(o), {.u = one(0.0), .v = one(0.0)}, 6.0, alone);
  ASSERT_EQ(record.events.size(), 2 * reference.events.size());
  EXPECT_NEAR(end.state.u[0], alone.state.u[0], 1e-9);
  EXPECT_NEAR(end.state.u[1], alone.state.u[0], 1e-9);
  for (std::size_t k = 0; k < reference.events.size(); ++k) {
    EXPECT_DOUBLE_EQ(record.events[2 * k].time, record.events[2 * k + 1].time);
  }
}

// The derivative of the flow against central differences through impacts, sticking and springs.
void expect_tangent(const Problem& problem, const State& start, double duration, double tolerance,
                    std::size_t least_events) {
  FlowState end;
  const FlowRecord record = flow_of(problem, start, duration, end, true);
  ASSERT_GE(record.events.size(), least_events);
  const Eigen::Index n = start.u.size();
  constexpr double kStep = 1e-5;
  for (Eigen::Index column = 0; column < 2 * n; ++column) {
    std::array<Eigen::VectorXd, 2> ends;
    for (std::size_t side = 0; side < 2; ++side) {
      State moved = start;
      (column < n ? moved.u[column] : moved.v[column - n]) += side == 0 ? kStep : -kStep;
      FlowState last;
      flow_of(problem, moved, duration, last);
      ends[side] = packed(last.state);
    }
    const Eigen::VectorXd slope = (ends[0] - ends[1]) / (2.0 * kStep);
    EXPECT_LT((slope - record.derivative.col(column)).norm(), tolerance * (1.0 + record.derivative.norm()))
        << "column " << column << "\n"
        << slope.transpose() << "\n"
        << record.derivative.col(column).transpose();
  }
}

TEST(EventFlow, DerivativeThroughImpactsAgreesWithDifferences) {
  expect_tangent(to_problem({.frequency = 2.2, .gap = 0.2, .restitution = 0.8}),
                 {.u = one(-0.3), .v = one(0.1)}, 10.0, 1e-6, 2);
  expect_tangent(two_masses(0.6, 0.5), {.u = Eigen::Vector2d(0.1, -0.2), .v = Eigen::Vector2d(0.3, 0.2)},
                 16.0, 1e-6, 2);
}

TEST(EventFlow, DerivativeThroughStickingAgreesWithDifferences) {
  Problem problem = two_masses(0.6, 0.0);
  problem.contacts.insert(problem.contacts.begin(),
                          {.normal = {{0, 1.0}}, .gap = 0.3, .law = problem.contacts.front().law});
  expect_tangent(problem, {.u = Eigen::Vector2d(0.1, -0.2), .v = Eigen::Vector2d(0.3, 0.2)}, 10.4, 1e-6, 3);
}

TEST(EventFlow, DerivativeThroughAChatterAgreesWithDifferences) {
  // The second mass carries the memory: the chattering one forgets everything. Steps of 1e-5 move the
  // impacts of the sequence by more than the last flights take, hence the wider tolerance.
  Problem problem = two_masses(0.15, 0.3);
  expect_tangent(problem, {.u = Eigen::Vector2d(0.1, -0.2), .v = Eigen::Vector2d(0.3, 0.2)}, 12.0, 1e-4, 6);
}

TEST(EventFlow, DerivativeThroughASpringStopAgreesWithDifferences) {
  Problem problem = two_masses(0.6, 0.0);
  problem.set_law(Penalty{{200.0}});
  expect_tangent(problem, {.u = Eigen::Vector2d(0.1, -0.2), .v = Eigen::Vector2d(0.3, 0.2)}, 10.0, 1e-5, 2);
}

TEST(EventFlow, StopsWhenTheBudgetIsSpent) {
  const Problem problem = two_masses(1.0, 0.5);
  const ContactDynamics dynamics(problem);
  EventFlow flow(dynamics, 1e-9, [] { return true; });
  FlowState state = flow.place(0.0, {.u = Eigen::Vector2d::Zero(), .v = Eigen::Vector2d::Zero()});
  FlowRecord record;
  EXPECT_THROW(flow.advance(state, 1.0, record), FlowError);
}

}  // namespace
}  // namespace signorini::flow_test
