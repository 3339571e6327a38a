#include "methods/discretisation/gauss_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace {

double integral_of_power(int power) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kGaussNodes.size(); ++k)
    sum += kGaussWeights[k] * (std::pow(kGaussNodes[k], power) + std::pow(-kGaussNodes[k], power));
  return sum;
}

TEST(GaussRule, IsExactUpToDegreeFifteenAndNoFurther) {
  for (int power = 0; power <= 15; ++power)
    EXPECT_NEAR(integral_of_power(power), power % 2 == 0 ? 2.0 / (power + 1) : 0.0, 1e-15) << power;
  EXPECT_GT(std::abs(integral_of_power(16) - 2.0 / 17.0), 1e-6);
}

}  // namespace
}  // namespace signorini
