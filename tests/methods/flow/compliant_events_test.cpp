// Which compliant stops push, against an exhaustive search of all sets of closed contacts.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>
#include <vector>

#include "methods/flow/stop_events.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/support/exact_scenes.hpp"

namespace signorini::compliant_events_test {
namespace {

// Five masses on springs to the wall, and three massless nodes tied to them and to each other, each with a
// stop of its own: stops whose compliance matrix is full. Nothing loads the nodes.
Problem masses_with_massless_nodes() {
  constexpr int kMasses = 5, kNodes = 3, kAll = kMasses + kNodes;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(kAll, kAll);
  const auto tie = [&K](int i, int j, double spring) {
    K(i, i) += spring;
    K(j, j) += spring;
    K(i, j) -= spring;
    K(j, i) -= spring;
  };
  for (int i = 0; i < kMasses; ++i) K(i, i) += 1.0;
  for (int node = 0; node < kNodes; ++node) {
    for (int i = 0; i < kMasses; ++i) tie(i, kMasses + node, 0.5 + 0.3 * ((i + 2 * node) % 3));
    for (int other = 0; other < node; ++other) tie(kMasses + other, kMasses + node, 2.0 + node);
  }
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(kAll);
  mass.head(kMasses).setOnes();
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(mass.asDiagonal()).sparseView();
    s.damping = Eigen::MatrixXd(0.1 * Eigen::MatrixXd(mass.asDiagonal())).sparseView();
    s.stiffness = K.sparseView();
  });
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  for (int node = 0; node < kNodes; ++node)
    problem.contacts.push_back({.normal = {{kMasses + node, 1.0}}, .gap = 0.1 + 0.05 * node});
  problem.set_law(Massless{});
  return problem;
}

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
      const Eigen::VectorXd solved = lu_solve(C(active, active), Eigen::VectorXd(-gap(active)));
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
  const Problem problem = masses_with_massless_nodes();
  const ContactDynamics dynamics(problem);
  const GivingEvents events(dynamics, 1e-9);
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
    EXPECT_EQ(events.place(0.0, state).closed, expected) << trial;
    with_contact += expected != std::vector<bool>(3, false) ? 1 : 0;
    EXPECT_EQ(events.place(0.7, state).closed, expected);
  }
  EXPECT_GT(with_contact, 20);
}

TEST(CompliantEvents, AContactAtItsStopIsDecidedByItsSpeed) {
  const Problem problem = test::penalty_oscillator(50.0);
  const ContactDynamics dynamics(problem);
  const GivingEvents events(dynamics, 1e-9);
  for (const double speed : {1.0, -1.0}) {
    const State state{.u = Eigen::VectorXd::Constant(1, 0.2), .v = Eigen::VectorXd::Constant(1, speed)};
    EXPECT_EQ(events.place(0.0, state).closed, std::vector<bool>{speed > 0.0});
  }
}

TEST(CompliantEvents, ResolvingLogsTheChangeAndNoImpulse) {
  const ContactDynamics dynamics(test::penalty_oscillator(50.0));
  const GivingEvents events(dynamics, 1e-9);
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
}  // namespace signorini::compliant_events_test
