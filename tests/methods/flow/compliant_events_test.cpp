// Which compliant stops push, against an exhaustive search of all sets of closed contacts.

#include "methods/flow/compliant_events.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "tests/support/exact_scenes.hpp"

namespace signorini {
namespace {

// The one set for which forces press and open contacts do not penetrate; empty if there are more or none.
std::vector<bool> only_admissible_set(const Eigen::MatrixXd& C, const Eigen::VectorXd& gap) {
  const auto count = static_cast<std::size_t>(gap.size());
  std::vector<std::vector<bool>> found;
  for (unsigned bits = 0; bits < (1U << count); ++bits) {
    std::vector<int> active;
    std::vector<bool> closed(count);
    for (std::size_t j = 0; j < count; ++j) {
      closed[j] = ((bits >> j) & 1U) != 0;
      if (closed[j]) active.push_back(static_cast<int>(j));
    }
    Eigen::VectorXd push = Eigen::VectorXd::Zero(gap.size());
    if (!active.empty()) {
      const Eigen::VectorXd solved = C(active, active).lu().solve(Eigen::VectorXd(-gap(active)));
      push(active) = solved;
    }
    const Eigen::VectorXd opening = C * push + gap;
    bool admissible = push.minCoeff() >= 0.0;
    for (std::size_t j = 0; j < count; ++j)
      admissible = admissible && (closed[j] || opening[static_cast<Eigen::Index>(j)] > 0.0);
    if (admissible) found.push_back(closed);
  }
  return found.size() == 1 ? found.front() : std::vector<bool>{};
}

TEST(CompliantEvents, PushingContactsAreTheAdmissibleSet) {
  const Platform platform;
  const ContactDynamics dynamics(platform.problem);
  const CompliantEvents events(dynamics, 1e-9);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 0.4);
  int with_contact = 0;
  for (int trial = 0; trial < 200; ++trial) {
    State state{.u = Eigen::VectorXd(5), .v = Eigen::VectorXd::Zero(5)};
    for (double& u : state.u) u = normal(generator);
    const Eigen::VectorXd gap =
        dynamics.structure().gaps - dynamics.structure().directions.transpose() * state.u;
    const std::vector<bool> expected = only_admissible_set(dynamics.structure().compliance, gap);
    ASSERT_EQ(expected.size(), 3U);
    EXPECT_EQ(events.pushing(0.0, state), expected) << trial;
    with_contact += expected != std::vector<bool>(3, false) ? 1 : 0;
    EXPECT_EQ(events.place(0.7, state).closed, expected);
  }
  EXPECT_GT(with_contact, 20);
}

TEST(CompliantEvents, AContactAtItsStopIsDecidedByItsSpeed) {
  const Problem problem = test::penalty_oscillator(50.0);
  const ContactDynamics dynamics(problem);
  const CompliantEvents events(dynamics, 1e-9);
  for (const double speed : {1.0, -1.0}) {
    const State state{.u = Eigen::VectorXd::Constant(1, 0.2), .v = Eigen::VectorXd::Constant(1, speed)};
    EXPECT_EQ(events.pushing(0.0, state), std::vector<bool>{speed > 0.0});
  }
}

TEST(CompliantEvents, ResolvingLogsTheChangeAndNoImpulse) {
  const ContactDynamics dynamics(test::penalty_oscillator(50.0));
  const CompliantEvents events(dynamics, 1e-9);
  FlowState flow{.time = 0.4,
                 .state = {.u = Eigen::VectorXd::Constant(1, 0.2), .v = Eigen::VectorXd::Constant(1, 1.0)},
                 .closed = {false}};
  const State before = flow.state;
  FlowRecord record;
  events.resolve(flow, 0, record);
  EXPECT_TRUE(flow.closed[0]);
  EXPECT_EQ(flow.state.v, before.v);  // the motion is continuous
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, ContactEvent::Kind::close);
  EXPECT_EQ(record.events[0].impulse, 0.0);
  ASSERT_EQ(record.sequence.size(), 1U);
  EXPECT_TRUE(record.sequence[0].pushed.empty());
  flow.state.v = -flow.state.v;
  events.resolve(flow, 0, record);
  EXPECT_FALSE(flow.closed[0]);
  EXPECT_EQ(record.events.back().kind, ContactEvent::Kind::open);
}

}  // namespace
}  // namespace signorini
