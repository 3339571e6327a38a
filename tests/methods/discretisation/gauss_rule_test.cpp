#include "methods/discretisation/gauss_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::gauss_rule_test {
namespace {

double integral_of_power(const GaussRule& rule, int power) {
  return (rule.weights.array() * rule.nodes.array().pow(power)).sum();
}

TEST(GaussRule, IsExactUpToTwiceItsNodesLessOneAndNoFurther) {
  for (const int count : {1, 2, 5, 8, 13}) {
    const GaussRule rule = gauss_rule(count);
    for (int power = 0; power < 2 * count; ++power)
      EXPECT_NEAR(integral_of_power(rule, power), power % 2 == 0 ? 2.0 / (power + 1) : 0.0, 4e-15) << count;
    EXPECT_GT(std::abs(integral_of_power(rule, 2 * count) - 2.0 / (2.0 * count + 1.0)), 1e-9) << count;
  }
}

TEST(GaussRule, HasRisingNodesAndPositiveWeightsWhereItIsLong) {
  const GaussRule rule = gauss_rule(1000);
  EXPECT_TRUE((rule.nodes.tail(999).array() > rule.nodes.head(999).array()).all());
  EXPECT_GT(rule.weights.minCoeff(), 0.0);
  EXPECT_NEAR(rule.weights.sum(), 2.0, 1e-12);
}

double error_of_wave(const GaussRule& rule, double z) {
  const double exact = 2.0 * (z == 0.0 ? 1.0 : std::sin(2.0 * z) / (2.0 * z));
  return std::abs((rule.weights.array() * (2.0 * z * rule.nodes.array()).cos()).sum() - exact);
}

// Of that many nodes all slower waves are integrated to rounding, too; of two thirds not.
TEST(GaussNodesFor, ReachRoundingWithFewMoreThanNeeded) {
  for (const double z : {0.01, 0.3, 1.0, 3.0, 10.0, 40.0, 200.0, 800.0}) {
    const int count = gauss_nodes_for(z);
    const GaussRule rule = gauss_rule(count);
    for (int part = 0; part <= 50; ++part)
      EXPECT_LT(error_of_wave(rule, z * part / 50), 1e-13 * (1.0 + z / 50.0)) << z;
    if (z >= 1.0) {
      EXPECT_GT(error_of_wave(gauss_rule(2 * count / 3), z), 1e-11) << z;
    }
  }
}

// A rule of a million nodes would take hours.
TEST(GaussNodesFor, AreFewForWhatIsNoNumberOrNegative) {
  for (const double z : {0.0, -1.0, std::nan("")}) EXPECT_EQ(gauss_nodes_for(z), 5) << z;
}

}  // namespace
}  // namespace signorini::gauss_rule_test
