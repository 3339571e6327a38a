#include "harness/judge/measures/impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/fake_method.hpp"

namespace signorini::impacts_test {
namespace {

using test::FormulaMotion;

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

Motion sampled(const Trajectory& motion) { return sample_motion(test::one_mass(), motion); }

TEST(ContactPhases, JoinRipplesAndTellImpactsFromLastingContact) {
  const int bandwidth = 20;
  const double T = kPeriod;
  const double resolution = T / (2.0 * bandwidth);
  // Two lobes half a resolution apart, across the period's end; and a push of a fifth of the period.
  const auto force = [=](double t) {
    const bool lobe = t > T - 0.6 * resolution || (t > 0.2 * resolution && t < 0.8 * resolution);
    const bool push = t > 0.4 * T && t < 0.6 * T;
    return lobe ? -2.0 : (push ? -1.0 : 0.0);
  };
  const FormulaMotion motion(
      T, [](double t) { return std::sin(2.0 * t); }, [](double t) { return 2.0 * std::cos(2.0 * t); }, force,
      {}, bandwidth);
  const std::vector<ContactPhase> phases = contact_phases(sampled(motion));
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_TRUE(phases[0].lasting);
  EXPECT_NEAR(phases[0].begin, 0.4 * T, 1e-3 * T);
  EXPECT_NEAR(phases[0].impulse, -0.2 * T, 1e-3 * T);
  EXPECT_FALSE(phases[1].lasting);
  EXPECT_NEAR(phases[1].impulse, -2.0 * 1.2 * resolution, 1e-3 * T);
}

TEST(ContactPhases, KnowAContactThatNeverOpens) {
  const FormulaMotion motion(
      kPeriod, [](double) { return 0.2; }, [](double) { return 0.0; },
      [](double t) { return -2.0 + std::cos(2.0 * t); }, {}, 10);
  const std::vector<ContactPhase> phases = contact_phases(sampled(motion));
  ASSERT_EQ(phases.size(), 1U);
  EXPECT_TRUE(phases[0].lasting);
  EXPECT_NEAR(phases[0].impulse, -2.0 * kPeriod, 1e-9);
  EXPECT_EQ(contact_ratio(sampled(motion)), 1.0);
}

/// x = -|sin 2t| / 2 strikes a stop at 0 at t = 0 and T / 2, at 1 m/s each time.
TEST(ContactPhases, TakeTheSpeedsBesideAListedImpactFromEitherSide) {
  const double T = kPeriod;
  const FormulaMotion motion(
      T, [](double t) { return -0.5 * std::abs(std::sin(2.0 * t)); },
      [](double t) {
        return (std::sin(2.0 * t) >= 0.0 && t < 0.5 * kPeriod ? -1.0 : 1.0) * std::cos(2.0 * t);
      },
      [](double) { return 0.0; },
      {{.contact = 0, .time = 0.0, .value = -2.0}, {.contact = 0, .time = 0.5 * T - 1e-5, .value = -2.0}});
  const std::vector<ContactPhase> phases = contact_phases(sampled(motion));
  ASSERT_EQ(phases.size(), 2U);
  for (const ContactPhase& phase : phases) {
    EXPECT_TRUE(phase.listed);
    EXPECT_EQ(phase.begin, phase.end);
    EXPECT_EQ(phase.impulse, -2.0);
    EXPECT_NEAR(phase.speed_before.value(), 1.0, 1e-4);
    EXPECT_NEAR(phase.speed_after.value(), -1.0, 1e-4);
  }
}

TEST(ContactPhases, LeaveASpeedOpenWhereAnotherImpactIsTooNear) {
  const double step = kPeriod / kGrid;
  const FormulaMotion motion(
      kPeriod, [](double t) { return std::sin(2.0 * t); }, [](double t) { return 2.0 * std::cos(2.0 * t); },
      [](double) { return 0.0; },
      {{.contact = 0, .time = 1.0, .value = -1.0}, {.contact = 0, .time = 1.0 + 0.5 * step, .value = -1.0}});
  const std::vector<ContactPhase> phases = contact_phases(sampled(motion));
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_TRUE(phases[0].speed_before);
  EXPECT_FALSE(phases[0].speed_after);
  EXPECT_FALSE(phases[1].speed_before);
  EXPECT_TRUE(phases[1].speed_after);
}

TEST(ContactRatio, IsTheShareOfThePeriodWithForce) {
  const FormulaMotion motion(
      kPeriod, [](double) { return 0.0; }, [](double) { return 0.0; },
      [](double t) { return t < 0.25 * kPeriod ? -1.0 : 0.0; });
  EXPECT_EQ(contact_ratio(sampled(motion)), 0.25);
}

TEST(TimeResolution, IsHalfAWaveOfTheHighestHarmonicOrOneStep) {
  const FormulaMotion::Formula zero = [](double) { return 0.0; };
  EXPECT_DOUBLE_EQ(time_resolution(sampled(FormulaMotion(kPeriod, zero, zero, zero, {}, 20))),
                   kPeriod / 40.0);
  EXPECT_DOUBLE_EQ(time_resolution(sampled(FormulaMotion(kPeriod, zero, zero, zero))), kPeriod / kGrid);
}

}  // namespace
}  // namespace signorini::impacts_test
