#include "harness/motion/stop_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::stop_statistics_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// x = sin t over a turn, whose stop of stiffness 2 at g = 0 presses while x > 0: lambda = -2 sin t there.
FlowRecord half_waves(double start) {
  FlowRecord record;
  const auto node = [&](double time, bool pressed) {
    FlowNode at{.time = start + time, .x = Eigen::MatrixXd(1, 6), .lambda = Eigen::MatrixXd::Zero(1, 5)};
    for (int k = 0; k < 6; ++k) at.x(0, k) = std::sin(time + 0.5 * kPi * k);
    if (pressed) at.lambda = -2.0 * at.x.leftCols(5);
    record.nodes.push_back(at);
  };
  constexpr int kSteps = 8;
  for (const bool pressed : {true, false})
    for (int i = 0; i <= kSteps; ++i) node((pressed ? 0.0 : kPi) + kPi * i / kSteps, pressed);
  return record;
}

TEST(StopSums, KnowsTheHalfWavesOfASpring) {
  StopSums sums(1);
  for (int period = 0; period < 4; ++period) sums.take(half_waves(2.0 * kPi * period), 2.0 * kPi);
  const StopStatistics stop = sums.statistics().front();
  EXPECT_NEAR(stop.x_mean.value, 0.0, 1e-10);
  EXPECT_NEAR(stop.x_rms.value, std::sqrt(0.5), 1e-10);
  EXPECT_NEAR(stop.x_min, -1.0, 1e-10);
  EXPECT_NEAR(stop.x_max, 1.0, 1e-10);
  ASSERT_TRUE(stop.force_rms && stop.force_peak);
  EXPECT_NEAR(stop.force_rms->value, 1.0, 1e-10);  // sqrt(4 / 2 / 2)
  EXPECT_NEAR(stop.force_peak->value, 2.0, 1e-10);
  EXPECT_NEAR(stop.impulse_per_second.value, 4.0 / (2.0 * kPi), 1e-10);
  EXPECT_NEAR(stop.impacts_per_second.value, 1.0 / (2.0 * kPi), 1e-12);
  ASSERT_TRUE(stop.impulse_mean && stop.impulse_deviation);
  EXPECT_NEAR(*stop.impulse_mean, 4.0, 1e-9);
  EXPECT_NEAR(*stop.impulse_deviation, 0.0, 1e-9);
  EXPECT_NEAR(stop.power->value, 0.0, 1e-10) << "a spring gives back what it takes";
}

// A mass of 3 that meets a rigid stop at 2 m/s and leaves at half of that: the impulse is 9 N s, the stop
// takes 4.5 J.
TEST(StopSums, KnowsAnImpact) {
  FlowRecord record;
  for (const auto& [time, x, velocity] :
       {std::tuple{0.0, -2.0, 2.0}, {1.0, 0.0, 2.0}, {1.0, 0.0, -1.0}, {2.0, -1.0, -1.0}}) {
    FlowNode node{.time = time, .x = Eigen::MatrixXd::Zero(1, 6), .lambda = Eigen::MatrixXd::Zero(1, 5)};
    node.x(0, 0) = x;
    node.x(0, 1) = velocity;
    record.nodes.push_back(node);
  }
  record.events = {{.kind = ContactEvent::Kind::impact, .contact = 0, .time = 1.0, .impulse = -9.0}};
  StopSums sums(1);
  sums.take(record, 2.0);
  const StopStatistics stop = sums.statistics().front();
  EXPECT_FALSE(stop.force_rms || stop.force_peak) << "an impulse has no width";
  EXPECT_DOUBLE_EQ(stop.impulse_per_second.value, 4.5);
  EXPECT_DOUBLE_EQ(stop.impacts_per_second.value, 0.5);
  EXPECT_DOUBLE_EQ(stop.power->value, 2.25);
  EXPECT_DOUBLE_EQ(stop.x_min, -2.0);
  EXPECT_DOUBLE_EQ(stop.x_max, 0.0);
}

}  // namespace
}  // namespace signorini::stop_statistics_test
