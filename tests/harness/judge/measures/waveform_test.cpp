#include "harness/judge/measures/waveform.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "harness/records/sampled_trajectory.hpp"

namespace signorini::waveform_test {
namespace {

Motion driven_at(double frequency, const Trajectory& motion) {
  Problem problem;
  problem.frequency = frequency;
  return sample_motion(problem, motion);
}

/// x = sin t at one contact, with a force of -1 N throughout, over `order` periods of 2 pi.
SampledTrajectory sine(int order, int contacts = 1, std::vector<Impulse> impulses = {}) {
  constexpr int kCount = 4096;
  SampledTrajectory::Data data;
  data.period = 2.0 * std::numbers::pi * order;
  data.samples.x.resize(kCount, contacts);
  data.samples.velocity.resize(kCount, contacts);
  data.samples.force = Eigen::MatrixXd::Constant(kCount, contacts, -1.0);
  for (int i = 0; i < kCount; ++i) {
    const double t = data.period * i / kCount;
    data.samples.x.row(i).setConstant(std::sin(t));
    data.samples.velocity.row(i).setConstant(std::cos(t));
  }
  data.impulses = std::move(impulses);
  return SampledTrajectory(std::move(data));
}

TEST(Polyline, KeepsCornersAndNothingElseOfStraightLines) {
  Eigen::MatrixXd signals(101, 2);
  for (int i = 0; i <= 100; ++i) {
    signals(i, 0) = std::abs(i - 30);
    signals(i, 1) = 7.0;  // a range of nothing asks for nothing
  }
  signals(50, 1) += 1e-15;  // nor does round-off
  EXPECT_EQ(polyline(signals, 1e-6), (std::vector<int>{0, 30, 100}));
}

TEST(DrawWaveforms, CountsAForceBetweenInstantsThatAreDrawnOnce) {
  // A peak of 1 N s at one sample, which is among those drawn or is not.
  for (const int peak : {1000, 1001, 1002, 1003}) {
    Motion motion = driven_at(1.0, sine(1));
    motion.samples.force.setZero();
    motion.samples.force(peak, 0) = -1.0 / motion.step();
    EXPECT_NEAR(draw_waveforms(motion, nullptr).answer.impulse[0].back(), -1.0, 1e-3) << peak;
  }
}

TEST(Polyline, StaysWithinItsToleranceOfEverySignal) {
  Eigen::MatrixXd signals(1001, 2);
  for (int i = 0; i <= 1000; ++i) {
    signals(i, 0) = 100.0 * std::sin(0.01 * i);
    signals(i, 1) = i == 500 ? 1e-3 : 0.0;
  }
  const std::vector<int> kept = polyline(signals, 0.01);
  EXPECT_LT(kept.size(), 40U);
  EXPECT_NE(std::find(kept.begin(), kept.end(), 500), kept.end());  // small in metres, all of its signal
  for (std::size_t k = 1; k < kept.size(); ++k) {
    for (int i = kept[k - 1]; i <= kept[k]; ++i) {
      const double share = static_cast<double>(i - kept[k - 1]) / (kept[k] - kept[k - 1]);
      const double line = (1.0 - share) * signals(kept[k - 1], 0) + share * signals(kept[k], 0);
      EXPECT_LE(std::abs(signals(i, 0) - line), 0.01 * 200.0 + 1e-12);
    }
  }
}

TEST(DrawWaveforms, CoversThePeriodCommonToAnswerAndOrbit) {
  const Motion answer = driven_at(1.0, sine(1));
  const Motion orbit = driven_at(1.0, sine(2));
  const Waveforms drawn = draw_waveforms(answer, &orbit);
  ASSERT_TRUE(drawn.orbit);
  EXPECT_EQ(drawn.contacts, std::vector<int>{0});
  for (const Waveform& waveform : {drawn.answer, *drawn.orbit}) {
    EXPECT_EQ(waveform.t.front(), 0.0);
    EXPECT_NEAR(waveform.t.back(), 4.0 * std::numbers::pi, 1e-2);
    EXPECT_LT(waveform.t.size(), 120U);
    EXPECT_EQ(waveform.x.front().size(), waveform.t.size());
    EXPECT_NEAR(waveform.impulse.front().back(), -4.0 * std::numbers::pi, 1e-2);
  }
}

TEST(DrawWaveforms, AddsImpulsesWhereTheyAct) {
  const SampledTrajectory answer = sine(1, 1, {{.contact = 0, .time = std::numbers::pi, .value = -10.0}});
  const Waveform drawn = draw_waveforms(driven_at(1.0, answer), nullptr).answer;
  for (std::size_t i = 0; i < drawn.t.size(); ++i) {
    if (std::abs(drawn.t[i] - std::numbers::pi) < 0.01) continue;
    const double before = drawn.t[i] > std::numbers::pi ? -10.0 : 0.0;
    EXPECT_NEAR(drawn.impulse.front()[i], before - drawn.t[i], 0.02) << drawn.t[i];
  }
}

TEST(DrawWaveforms, KeepsTheContactsThatExchangeMostImpulse) {
  const SampledTrajectory answer = sine(1, 6,
                                        {{.contact = 5, .time = 1.0, .value = -3.0},
                                         {.contact = 1, .time = 1.0, .value = -2.0},
                                         {.contact = 4, .time = 1.0, .value = -1.0},
                                         {.contact = 2, .time = 1.0, .value = -4.0}});
  EXPECT_EQ(draw_waveforms(driven_at(1.0, answer), nullptr).contacts, (std::vector<int>{1, 2, 4, 5}));
}

}  // namespace
}  // namespace signorini::waveform_test
