#include "harness/judge/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/judge/orbit.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/records/trajectory_json.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

using test::FormulaMotion;

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

/// cos(omega t) and a subharmonic of half the frequency, over `order` forcing periods, `shift` of them late.
Motion motion(int order, double subharmonic, int shift = 0, std::vector<Impulse> impulses = {}) {
  const double late = shift * kPeriod;
  return sample_motion(
      test::one_mass(),
      FormulaMotion(
          order * kPeriod, [=](double t) { return std::cos(2.0 * t) + subharmonic * std::cos(t - late); },
          [=](double t) { return -2.0 * std::sin(2.0 * t) - subharmonic * std::sin(t - late); },
          [](double) { return 0.0; }, std::move(impulses)));
}

TEST(SampleMotion, KnowsTheOrderOfTheMotion) {
  EXPECT_EQ(motion(1, 0.0).order, 1);
  EXPECT_EQ(motion(2, 0.5).order, 2);
  EXPECT_EQ(motion(2, 0.5).count(), 2 * kGrid);
  EXPECT_NEAR(motion(2, 0.5).period(), 2.0 * kPeriod, 1e-12);
}

TEST(Distance, IsTakenOverTheCommonPeriod) {
  // |0.5 cos t| against |cos 2 t|: 0.5; the other way the norm is that of both together.
  EXPECT_NEAR(distance(motion(2, 0.5), motion(1, 0.0)).x_l2.value(), 0.5, 1e-12);
  EXPECT_NEAR(distance(motion(1, 0.0), motion(2, 0.5)).x_l2.value(), 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(distance(motion(3, 0.0), motion(2, 0.5)).x_l2.value(), 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(distance(motion(2, 0.5), motion(2, 0.5)).x_l2.value(), 0.0);
}

TEST(BestShift, UndoesAShiftByForcingPeriods) {
  const Motion original = motion(2, 0.5);
  const Motion late = motion(2, 0.5, 1);
  EXPECT_NEAR(distance(original, late).x_l2.value(), 1.0 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(best_shift(original, late), 1);
  EXPECT_LT(distance(original, late, 1).x_l2.value(), 1e-12);
  EXPECT_TRUE(same_orbit(original, late));
  EXPECT_FALSE(same_orbit(original, motion(2, 0.4)));
}

TEST(LeastOrder, FindsTheTruePeriod) {
  EXPECT_EQ(least_order(motion(1, 0.0)), 1);
  EXPECT_EQ(least_order(motion(6, 0.0)), 1);
  EXPECT_EQ(least_order(motion(6, 0.5)), 2);
  EXPECT_EQ(least_order(motion(2, 0.5)), 2);
}

TEST(Fingerprint, IsEqualForEqualOrbits) {
  const std::vector<Impulse> once{{0, 1.0, -0.5}};
  const std::vector<Impulse> late{{0, 1.0 + kPeriod, -0.5}};
  const std::vector<Impulse> twice{{0, 1.0, -0.5}, {0, 1.0 + 2.0 * kPeriod, -0.5}};
  const std::string print = fingerprint(motion(2, 0.5, 0, once));
  EXPECT_EQ(print.size(), 8U);
  EXPECT_EQ(print, fingerprint(motion(2, 0.5, 1, late)));   // one forcing period later
  EXPECT_EQ(print, fingerprint(motion(4, 0.5, 0, twice)));  // written over two of its periods
}

TEST(Fingerprint, DiffersForOtherOrbits) {
  const std::string print = fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.5}}));
  EXPECT_NE(print, fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.6}})));
  EXPECT_NE(print, fingerprint(motion(2, 0.51, 0, {{0, 1.0, -0.5}})));
  EXPECT_NE(print, fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.25}, {0, 2.0, -0.25}})));
  EXPECT_NE(print, fingerprint(motion(1, 0.0)));
}

TEST(OrbitEvents, ListImpactsAndPlaceClosingAndOpening) {
  // The stop's spring pushes between asin(0.5) and pi - asin(0.5) of the phase.
  const auto x = [](double t) { return std::sin(2.0 * t); };
  const FormulaMotion spring(
      kPeriod, x, [](double t) { return 2.0 * std::cos(2.0 * t); },
      [=](double t) { return -3.0 * std::max(0.0, x(t) - 0.5); });
  const std::vector<OrbitEvent> events = orbit_events(sample_motion(test::one_mass(), spring));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, "close");
  EXPECT_NEAR(events[0].time, std::numbers::pi / 12.0, 1e-6);
  EXPECT_EQ(events[1].kind, "open");
  EXPECT_NEAR(events[1].time, 5.0 * std::numbers::pi / 12.0, 1e-6);
  EXPECT_FALSE(events[1].value.has_value());
  const std::vector<OrbitEvent> impacts = orbit_events(motion(1, 0.0, 0, {{0, 1.0, -0.5}}));
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_EQ(impacts[0].kind, "impact");
  EXPECT_EQ(impacts[0].value, -0.5);
}

TEST(SampledTrajectory, GivesBackItsSamplesBitByBit) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 512);
  const Samples stored = sampled.data().samples;
  EXPECT_EQ(sampled.sample(512).x, stored.x);
  const Samples thinned = sampled.sample(128);
  for (int i = 0; i < 128; ++i) EXPECT_EQ(thinned.x(i, 0), stored.x(4 * i, 0));
}

TEST(SampledTrajectory, InterpolatesAtFourthOrder) {
  const auto source = test::free_motion(test::one_mass());
  const auto error = [&](int stored) {
    return (SampledTrajectory(*source, stored).sample(3000).x - source->sample(3000).x).cwiseAbs().maxCoeff();
  };
  const double order = std::log2(error(64) / error(128));
  EXPECT_NEAR(order, 4.0, 0.2);
}

TEST(SampledTrajectory, RefusesWhatIsNoMotion) {
  const auto source = test::free_motion(test::one_mass());
  SampledTrajectory::Data data{source->period(), source->sample(16), {}, {}};
  data.samples.force(3, 0) = std::nan("");
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
  data = {0.0, source->sample(16), {}, {}};
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
  data = {1.0, source->sample(16), {{.contact = 2, .time = 0.0, .value = -1.0}}, {}};
  EXPECT_THROW(SampledTrajectory{data}, std::invalid_argument);
}

TEST(TrajectoryJson, ComesBackAsItWent) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 32);
  const auto back = trajectory_of(source->period(), samples_of(sampled, 32));
  EXPECT_EQ(back->sample(32).x, sampled.sample(32).x);
  EXPECT_EQ(back->bandwidth(), source->bandwidth());
  TrajectorySamples uneven = samples_of(sampled, 32);
  uneven.force[0].pop_back();
  EXPECT_THROW(trajectory_of(1.0, uneven), BadRecord);
}

SampledTrajectory with_an_impulse() {
  SampledTrajectory::Data data{.period = 2.0,
                               .samples = {},
                               .impulses = {{.contact = 0, .time = 1.75, .value = -3.0}},
                               .bandwidth = 5};
  data.samples.x = Eigen::Vector4d(0.0, 1.0, 2.0, 3.0);
  data.samples.velocity = data.samples.force = -data.samples.x;
  return SampledTrajectory(std::move(data));
}

TEST(Delayed, MovesSamplesAndImpulsesBackInTime) {
  const SampledTrajectory late = delayed(with_an_impulse(), 0.25);
  EXPECT_EQ(late.sample(4).x.col(0), Eigen::Vector4d(3.0, 0.0, 1.0, 2.0));
  EXPECT_EQ(late.sample(4).force.col(0), Eigen::Vector4d(-3.0, 0.0, -1.0, -2.0));
  EXPECT_DOUBLE_EQ(late.impulses().front().time, 0.25);
  EXPECT_EQ(delayed(with_an_impulse(), 0.0).impulses().front().time, 1.75);
}

TEST(Repeated, TakesSeveralPeriodsForOne) {
  const SampledTrajectory twice = repeated(with_an_impulse(), 2);
  EXPECT_EQ(twice.period(), 4.0);
  EXPECT_EQ(twice.sample(8).x(5, 0), 1.0);
  EXPECT_EQ(twice.bandwidth(), 10);
  ASSERT_EQ(twice.impulses().size(), 2U);
  EXPECT_EQ(twice.impulses()[1].time, 3.75);
}

}  // namespace
}  // namespace signorini
