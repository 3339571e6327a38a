#include "harness/judge/orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/harness/fake_method.hpp"

namespace signorini::orbit_test {
namespace {

using test::FormulaMotion;

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

/// cos(omega t) and a subharmonic of half the frequency, over `order` forcing periods, `shift` of them late.
Motion motion(int order, double subharmonic, int shift = 0, std::vector<Impulse> impulses = {},
              double origin = 0.0) {
  const double late = shift * kPeriod;
  return sample_motion(
      test::one_mass(),
      FormulaMotion(
          order * kPeriod,
          [=](double t) { return origin + std::cos(2.0 * t) + subharmonic * std::cos(t - late); },
          [=](double t) { return -2.0 * std::sin(2.0 * t) - subharmonic * std::sin(t - late); },
          [](double) { return 0.0; }, std::move(impulses)));
}

TEST(SameOrbit, IsToldWhateverTheShiftByForcingPeriods) {
  EXPECT_TRUE(same_orbit(motion(2, 0.5), motion(2, 0.5, 1)));
  EXPECT_FALSE(same_orbit(motion(2, 0.5), motion(2, 0.4)));
  EXPECT_TRUE(same_orbit(motion(4, 0.5), motion(2, 0.5))) << "written over two of its periods";
}

TEST(Fingerprint, IsEqualForEqualOrbits) {
  const std::vector<Impulse> once{{0, 1.0, -0.5}};
  const std::vector<Impulse> late{{0, 1.0 + kPeriod, -0.5}};
  const std::vector<Impulse> twice{{0, 1.0, -0.5}, {0, 1.0 + 2.0 * kPeriod, -0.5}};
  const std::string print = fingerprint(motion(2, 0.5, 0, once));
  EXPECT_EQ(print.size(), 8U);
  EXPECT_EQ(print, fingerprint(motion(2, 0.5, 1, late)));          // one forcing period later
  EXPECT_EQ(print, fingerprint(motion(4, 0.5, 0, twice)));         // written over two of its periods
  EXPECT_EQ(print, fingerprint(motion(2, 0.5, 0, once, 1000.0)));  // from another origin
}

TEST(Fingerprint, DiffersForOtherOrbits) {
  const std::string print = fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.5}}));
  EXPECT_NE(print, fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.6}})));
  EXPECT_NE(print, fingerprint(motion(2, 0.51, 0, {{0, 1.0, -0.5}})));
  EXPECT_NE(print, fingerprint(motion(2, 0.5, 0, {{0, 1.0, -0.25}, {0, 2.0, -0.25}})));
  EXPECT_NE(print, fingerprint(motion(1, 0.0)));
}

/// Two contacts that move alike, the second one `shift` forcing periods later.
Motion twins(int shift) {
  Motion both = motion(2, 0.5, 0, {{0, 1.0, -0.5}, {1, 1.0 + shift * kPeriod, -0.5}});
  const Motion second = motion(2, 0.5, shift);
  for (auto part : {&Samples::x, &Samples::velocity, &Samples::force}) {
    (both.samples.*part).conservativeResize(Eigen::NoChange, 2);
    (both.samples.*part).col(1) = (second.samples.*part).col(0);
  }
  return both;
}

TEST(Fingerprint, TellsStopsStruckAtOnceFromStopsStruckInTurn) {
  EXPECT_NE(fingerprint(twins(0)), fingerprint(twins(1)));
  EXPECT_EQ(fingerprint(twins(1)), fingerprint(twins(3)));
}

TEST(LargestImpulse, IsThatOfTheMagnitudesOfEvents) {
  using Kind = ContactEvent::Kind;
  EXPECT_EQ(largest_impulse({}), 0.0);
  EXPECT_EQ(largest_impulse(std::vector<OrbitEvent>{{0.1, 0, Kind::close, {}}, {0.2, 0, Kind::open, {}}}),
            0.0);
  EXPECT_EQ(largest_impulse(std::vector<OrbitEvent>{
                {0.1, 0, Kind::impact, -0.5}, {0.2, 1, Kind::close, {}}, {0.3, 1, Kind::impact, 0.25}}),
            0.5);
}

TEST(OrbitEvents, ListImpactsAndPlaceClosingAndOpening) {
  // The stop's spring pushes between asin(0.5) and pi - asin(0.5) of the phase.
  const auto x = [](double t) { return std::sin(2.0 * t); };
  const FormulaMotion spring(
      kPeriod, x, [](double t) { return 2.0 * std::cos(2.0 * t); },
      [=](double t) { return -3.0 * std::max(0.0, x(t) - 0.5); });
  const std::vector<OrbitEvent> events = orbit_events(sample_motion(test::one_mass(), spring));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, ContactEvent::Kind::close);
  EXPECT_NEAR(events[0].time, std::numbers::pi / 12.0, 1e-6);
  EXPECT_EQ(events[1].kind, ContactEvent::Kind::open);
  EXPECT_NEAR(events[1].time, 5.0 * std::numbers::pi / 12.0, 1e-6);
  EXPECT_FALSE(events[1].value.has_value());
  const std::vector<OrbitEvent> impacts = orbit_events(motion(1, 0.0, 0, {{0, 1.0, -0.5}}));
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_EQ(impacts[0].kind, ContactEvent::Kind::impact);
  EXPECT_EQ(impacts[0].value, -0.5);
}

}  // namespace
}  // namespace signorini::orbit_test
