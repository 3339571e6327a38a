#include "methods/flow/event_trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/methods/event_driven/scenes.hpp"

namespace signorini::event_trajectory_test {
namespace {

// x = sin(3 t), lambda = -2 - cos(2 t) on two pieces, the cut in the middle of the period.
EventTrajectory waves(double step) {
  const double period = 2.0 * std::numbers::pi;
  const double begin = 1.0;
  std::vector<FlowNode> nodes;
  const auto node = [](double t) {
    FlowNode result{.time = t, .x = Eigen::MatrixXd(1, 6), .lambda = Eigen::MatrixXd(1, 5)};
    for (int k = 0; k < 6; ++k)
      result.x(0, k) = std::pow(3.0, k) * std::sin(3.0 * t + 0.5 * std::numbers::pi * k);
    for (int k = 0; k < 5; ++k) {
      result.lambda(0, k) =
          (k == 0 ? -2.0 : 0.0) - std::pow(2.0, k) * std::cos(2.0 * t + 0.5 * std::numbers::pi * k);
    }
    return result;
  };
  for (int piece = 0; piece < 2; ++piece) {
    const int count = static_cast<int>(std::ceil(0.5 * period / step));
    for (int i = 0; i <= count; ++i)
      nodes.push_back(node(begin + 0.5 * period * (piece + static_cast<double>(i) / count)));
  }
  FlowState start{.time = begin,
                  .state = {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)},
                  .closed = {false}};
  std::vector<ContactEvent> events{
      {.kind = ContactEvent::Kind::impact, .contact = 0, .time = period + 0.25, .impulse = -2.0}};
  return {period, start, nodes, events};
}

double worst_error(double step) {
  const Samples samples = waves(step).sample(777);
  double worst = 0.0;
  for (int i = 0; i < 777; ++i) {
    const double t = 2.0 * std::numbers::pi * i / 777;
    worst = std::max({worst, std::abs(samples.x(i, 0) - std::sin(3.0 * t)),
                      std::abs(samples.velocity(i, 0) - 3.0 * std::cos(3.0 * t)) / 3.0,
                      std::abs(samples.force(i, 0) + 2.0 + std::cos(2.0 * t)) / 3.0});
  }
  return worst;
}

TEST(EventTrajectory, InterpolatesWithTheTenthPowerOfTheStep) {
  const double coarse = worst_error(0.8), fine = worst_error(0.4);
  EXPECT_NEAR(std::log2(coarse / fine), 10.0, 1.0);
  EXPECT_LT(worst_error(0.1), 1e-14);
}

TEST(EventTrajectory, WrapsEventTimesIntoThePeriod) {
  const auto impulses = waves(0.5).impulses();
  ASSERT_EQ(impulses.size(), 1U);
  EXPECT_NEAR(impulses[0].time, 0.25, 1e-14);
  EXPECT_DOUBLE_EQ(impulses[0].value, -2.0);
}

// Between the impacts the interpolation must be as good as the integration, whatever the instants asked for.
TEST(EventTrajectory, DenseOutputOfAnImpactOrbitIsAsAccurateAsItsIntegration) {
  const test::ImpactOscillator o{.frequency = 2.2, .gap = 0.2, .restitution = 0.5};
  const auto orbits = test::single_impact_orbits(o);
  ASSERT_FALSE(orbits.empty());
  const Solution solution = test::solve(test::to_problem(o), {.tolerance = 1e-12});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  constexpr int kCount = 20011;
  const Samples samples = solution.trajectory->sample(kCount);
  const double period = solution.trajectory->period();
  for (int i = 0; i < kCount; ++i) {
    const double time = i * period / kCount;
    if (std::abs(std::remainder(time - orbits[0].impact_time, period)) < 1e-9)
      continue;  // on which side it is
    ASSERT_NEAR(samples.x(i, 0), orbits[0].x(time), 1e-11);
    ASSERT_NEAR(samples.velocity(i, 0), orbits[0].velocity(time), 2e-11);
  }
}

TEST(EventTrajectory, VelocityIsRightSidedAtAnImpact) {
  // Impact at t = 0: place the stop so that the closed-form orbit hits there.
  const test::ImpactOscillator o{.frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  Problem problem = test::to_problem(o);
  const auto orbit = test::single_impact_orbits(o).at(0);
  const double shift = o.frequency * orbit.impact_time;  // cos(w (t + t0))
  problem.force = {{.dof = 0, .harmonic = 1, .cos = std::cos(shift), .sin = -std::sin(shift)}};
  const Solution solution = test::solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto impulses = solution.trajectory->impulses();
  ASSERT_EQ(impulses.size(), 1U);
  const double period = solution.trajectory->period();
  EXPECT_NEAR(std::remainder(impulses[0].time, period), 0.0, 1e-9);
  // Just after it, x' is the rebound speed; just before, the approach.
  const Samples samples = solution.trajectory->sample(1 << 20);
  EXPECT_NEAR(samples.velocity(1, 0), -0.8 * orbit.approach, 1e-5);
  EXPECT_NEAR(samples.velocity((1 << 20) - 1, 0), orbit.approach, 1e-5);
}

}  // namespace
}  // namespace signorini::event_trajectory_test
