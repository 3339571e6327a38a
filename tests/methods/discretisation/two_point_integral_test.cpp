#include "methods/discretisation/two_point_integral.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::two_point_integral_test {
namespace {

/// x^n and its derivatives.
Derivatives power(double x, int n) {
  Derivatives values{};
  double factor = 1.0;
  for (int k = 0; k < 5 && k <= n; ++k) {
    values[static_cast<std::size_t>(k)] = factor * std::pow(x, n - k);
    factor *= n - k;
  }
  return values;
}

TEST(TwoPointIntegral, IsExactForPolynomialsOfDegreeNine) {
  for (int n = 0; n <= 9; ++n)
    EXPECT_NEAR(two_point_integral(2.0, power(1.0, n), power(3.0, n)), (std::pow(3.0, n + 1) - 1.0) / (n + 1),
                1e-14 * std::pow(3.0, n + 1))
        << n;
  EXPECT_GT(
      std::abs(two_point_integral(2.0, power(1.0, 10), power(3.0, 10)) - (std::pow(3.0, 11) - 1.0) / 11),
      1e-6);
}

TEST(TwoPointIntegral, ConvergesAtTheOrderTenOnAHalfWave) {
  const auto sine = [](double t) {
    return Derivatives{std::sin(t), std::cos(t), -std::sin(t), -std::cos(t), std::sin(t)};
  };
  const auto error = [&](int pieces) {
    const double h = std::numbers::pi / pieces;
    double sum = -2.0;
    for (int i = 0; i < pieces; ++i) sum += two_point_integral(h, sine(i * h), sine((i + 1) * h));
    return std::abs(sum);
  };
  EXPECT_LT(error(2), 2e-8);
  EXPECT_NEAR(std::log2(error(1) / error(2)), 10.0, 0.6);
  EXPECT_NEAR(std::log2(error(2) / error(4)), 10.0, 0.6);
}

}  // namespace
}  // namespace signorini::two_point_integral_test
