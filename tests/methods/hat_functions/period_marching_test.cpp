#include "methods/hat_functions/period_marching.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::period_marching_test {
namespace {

const test::ImpactOscillator kPlastic{.damping = 0.2, .frequency = 1.0, .gap = 0.1, .restitution = 0.0};

// Stepped for so many periods that rest is forgotten, the recurrence written out for one mass.
Eigen::VectorXd stepped(const Problem& problem, double e, int nodes, int periods) {
  const double dt = problem.period() / nodes;
  const double m = problem.mass().coeff(0, 0), d = problem.damping().coeff(0, 0);
  const double k = problem.stiffness().coeff(0, 0), gap = problem.contacts[0].gap;
  const double ahead = m / (dt * dt) + d / (2.0 * dt), behind = m / (dt * dt) - d / (2.0 * dt);
  const double here = k - 2.0 * m / (dt * dt);
  double before = 0.0, now = 0.0;
  Eigen::VectorXd pressure(nodes);
  for (int step = 0; step < nodes * periods; ++step) {
    double next = (load_at(problem, step * dt)[0] - here * now - behind * before) / ahead;
    const double room = (1.0 + e) * gap - (next + e * before);
    pressure[step % nodes] = room < 0.0 ? -room * ahead : 0.0;
    if (room < 0.0) next += room;
    before = now;
    now = next;
  }
  return pressure;
}

TEST(MarchToPeriod, EndsWithTheContactOfTheSteadyMotion) {
  constexpr int kNodes = 200;
  const Problem problem = test::to_problem(kPlastic);
  const Eigen::VectorXd pressure =
      march_to_period(problem, HatScheme::nodal, kNodes, nodal_stops(problem, {0.0}), 300, {});
  ASSERT_EQ(pressure.size(), kNodes);
  const Eigen::VectorXd steady = stepped(problem, 0.0, kNodes, 200);
  EXPECT_GT(steady.maxCoeff(), 0.0);
  for (int i = 0; i < kNodes; ++i) EXPECT_EQ(pressure[i] > 0.0, steady[i] > 0.0) << "node " << i;
  EXPECT_LE((pressure - steady).norm(), 0.05 * steady.norm());
}

TEST(MarchToPeriod, FindsNothingWhereThereIsNoContactOrNoTime) {
  Problem problem = test::to_problem(kPlastic);
  const Start late{.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)};
  const auto marched = [&problem](int periods, const Start& start) {
    return march_to_period(problem, HatScheme::galerkin, 64, nodal_stops(problem, {0.0}), periods, start);
  };
  EXPECT_EQ(marched(300, late).size(), 0);
  EXPECT_EQ(marched(1, {}).size(), 0);  // one period repeats nothing
  problem.contacts[0].gap = 1e3;
  EXPECT_EQ(marched(20, {}).size(), 0);
}

}  // namespace
}  // namespace signorini::period_marching_test
