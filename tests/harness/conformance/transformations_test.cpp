#include "harness/conformance/transformations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

constexpr double kPeriod = 2.0;

std::shared_ptr<const Trajectory> motion() {
  const double w = 2.0 * std::numbers::pi / kPeriod;
  return std::make_shared<test::FormulaMotion>(
      kPeriod, [w](double t) { return std::sin(w * t) + 0.3 * std::cos(3.0 * w * t); },
      [w](double t) { return w * std::cos(w * t) - 0.9 * w * std::sin(3.0 * w * t); },
      [w](double t) { return -1.0 - std::sin(w * t); },
      std::vector<Impulse>{{.contact = 0, .time = 0.25, .value = -2.0},
                           {.contact = 0, .time = 1.75, .value = -4.0}});
}

// Against the formula at shifted times: no grid enters.
TEST(MappedMotion, IsTheMotionLaterAndInOtherUnitsAtAnyNumberOfSamples) {
  const MotionMap map{.displacement = 3.0, .force = 5.0, .time = 0.5, .delay = 21, .grid = 64};
  const MappedMotion mapped(motion(), map);
  EXPECT_DOUBLE_EQ(mapped.period(), 1.0);
  const double w = std::numbers::pi;
  for (const int count : {1, 7, 64, 100}) {
    const Samples samples = mapped.sample(count);
    ASSERT_EQ(samples.x.rows(), count);
    for (int i = 0; i < count; ++i) {
      const double t = kPeriod * (static_cast<double>(i) / count - 21.0 / 64.0);
      EXPECT_NEAR(samples.x(i, 0), 3.0 * (std::sin(w * t) + 0.3 * std::cos(3.0 * w * t)), 1e-12);
      EXPECT_NEAR(samples.velocity(i, 0), 6.0 * w * (std::cos(w * t) - 0.9 * std::sin(3.0 * w * t)), 1e-11);
      EXPECT_NEAR(samples.force(i, 0), 5.0 * (-1.0 - std::sin(w * t)), 1e-12);
    }
  }
}

TEST(MappedMotion, OrdersItsImpulsesWithinThePeriod) {
  const MappedMotion mapped(motion(),
                            {.displacement = 1.0, .force = 5.0, .time = 0.5, .delay = 1, .grid = 2});
  const std::vector<Impulse> impulses = mapped.impulses();
  ASSERT_EQ(impulses.size(), 2U);
  EXPECT_DOUBLE_EQ(impulses[0].time, 0.375);  // 1.75 / 2 + 1 / 2, less the period
  EXPECT_DOUBLE_EQ(impulses[0].value, -10.0);
  EXPECT_DOUBLE_EQ(impulses[1].time, 0.625);
  EXPECT_DOUBLE_EQ(impulses[1].value, -5.0);
}

TEST(MappedMotion, IsUndoneByTheInverseMap) {
  const MotionMap map{.displacement = 3.0, .force = 5.0, .time = 0.5, .delay = 21, .grid = 64};
  const MappedMotion back(std::make_shared<MappedMotion>(motion(), map), map.inverse());
  const Samples before = motion()->sample(50), after = back.sample(50);
  EXPECT_LE((before.x - after.x).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((before.velocity - after.velocity).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LE((before.force - after.force).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace signorini
