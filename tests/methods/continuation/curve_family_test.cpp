#include "methods/continuation/curve_family.hpp"

#include <gtest/gtest.h>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::curve_family_test {
namespace {

CurveFamily family_of(double from, double to) {
  return curve_family(test::to_problem({.load = 3.0, .gap = 0.2}), from, to);
}

TEST(CurveFamily, UnitsAreThoseOfTheScene) {
  const CurveFamily family = family_of(4.5, 1.5);
  EXPECT_EQ(family.low, 1.5);
  EXPECT_EQ(family.high, 4.5);
  EXPECT_EQ(family.problem.frequency, 3.0);
  EXPECT_DOUBLE_EQ(family.frequency_unit, 1.0);
  EXPECT_DOUBLE_EQ(family.displacement_unit, 3.0) << "the static deflection";
  EXPECT_TRUE(family.is_below_middle(2.9));
  EXPECT_FALSE(family.is_below_middle(3.1));
}

TEST(CurveFamily, TellsWhatAStepMeetsFirst) {
  const CurveFamily family = family_of(1.5, 7.5);  // whose unit is 2
  const Eigen::Vector2d x(0.0, 1.0);
  EXPECT_FALSE(family.target({5.0}, x, 4.0));
  EXPECT_EQ(family.target({5.0}, x, 6.0)->value, 5.0);
  EXPECT_TRUE(family.target({5.0}, x, 1.0)->leaves);
}

TEST(CurveFamily, TellsWhereTheFrequencyTurnsPastAValue) {
  const CurveFamily family = family_of(1.5, 7.5);
  const Eigen::VectorXd rising = Eigen::Vector2d(0.9, 0.4).normalized();
  const Eigen::VectorXd falling = Eigen::Vector2d(0.9, -0.4).normalized();
  const CurveStep step{Eigen::Vector2d(0.0, 1.0), rising, 1.0};  // from 2 to 2, over 2.25
  EXPECT_TRUE(family.turns_past({2.2}, step, 2.0, falling));
  EXPECT_FALSE(family.turns_past({3.0}, step, 2.0, falling));
  EXPECT_FALSE(family.turns_past({2.2}, {step.x, step.tangent, 1e-6}, 2.0, falling));
}

}  // namespace
}  // namespace signorini::curve_family_test
