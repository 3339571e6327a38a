#include "harness/motion/lyapunov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::lyapunov_test {
namespace {

// The map (x, y) -> (1 - 1.4 x^2 + y, 0.3 x): 0.41922 [sprott2003, table of maps], and the determinant is
// -0.3 everywhere, so that the exponents sum to log 0.3.
TEST(LyapunovSum, KnowsHenonsMap) {
  LyapunovSum sum(2, 2);
  double x = 0.1, y = 0.1;
  for (int n = 0; n < 20000; ++n) {
    Eigen::MatrixXd derivative(2, 2);
    derivative << -2.8 * x, 1.0, 0.3, 0.0;
    sum.take(derivative * sum.frame());
    const double next = 1.0 - 1.4 * x * x + y;
    y = 0.3 * x;
    x = next;
  }
  const std::vector<Estimate> exponents = sum.exponents();
  ASSERT_EQ(exponents.size(), 2U);
  EXPECT_NEAR(exponents[0].value, 0.41922, exponents[0].error + 1e-3);
  EXPECT_LT(exponents[0].error, 0.02);
  EXPECT_NEAR(exponents[0].value + exponents[1].value, std::log(0.3), 1e-10);
}

// x -> 4 x (1 - x), whose exponent is log 2 for almost every start.
TEST(LyapunovSum, ErrorsHoldTheExponentOfTheLogisticMap) {
  constexpr int kTrials = 200;
  int inside = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    LyapunovSum sum(1, 1);
    double x = 0.1 + 0.0037 * trial;
    for (int n = 0; n < 1000; ++n) {
      sum.take(Eigen::MatrixXd::Constant(1, 1, 4.0 * (1.0 - 2.0 * x)) * sum.frame());
      x = 4.0 * x * (1.0 - x);
    }
    const Estimate exponent = sum.exponents().front();
    EXPECT_LT(exponent.error, 0.1);
    inside += std::abs(exponent.value - std::log(2.0)) <= exponent.error ? 1 : 0;
  }
  EXPECT_NEAR(inside, 0.95 * kTrials, 0.05 * kTrials);
}

// A rotation seen in axes of which one is three times as long: deviations swing by that factor.
TEST(LyapunovSum, GrowthIsBoundedOnATorus) {
  const double cosine = std::cos(1.0), sine = std::sin(1.0);
  Eigen::MatrixXd derivative(2, 2);
  derivative << cosine, -sine / 3.0, 3.0 * sine, cosine;
  LyapunovSum sum(2, 2);
  for (int n = 0; n < 2000; ++n) sum.take(derivative * sum.frame());
  EXPECT_NEAR(sum.largest_growth(), std::log(3.0), 1e-4);
  EXPECT_NEAR(sum.exponents().front().value, 0.0, sum.exponents().front().error);
}

// Neighbours that drift apart evenly are n apart after n steps.
TEST(LyapunovSum, GrowthByAnEvenDriftIsThatSinceTheFirstTenth) {
  Eigen::MatrixXd derivative(2, 2);
  derivative << 1.0, 0.0, 1.0, 1.0;
  LyapunovSum sum(2, 1);
  for (int n = 0; n < 1000; ++n) sum.take(derivative * sum.frame());
  EXPECT_NEAR(sum.largest_growth(), std::log(std::hypot(1.0, 1000.0) / std::hypot(1.0, 100.0)), 1e-9);
}

TEST(LyapunovSum, LeavesOutStepsWithoutADerivative) {
  LyapunovSum sum(3, 1);
  for (int n = 0; n < 40; ++n) sum.take(2.0 * sum.frame());
  sum.take(Eigen::MatrixXd::Constant(3, 1, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(sum.steps(), 40U);
  EXPECT_NEAR(sum.exponents().front().value, std::log(2.0), 1e-14);
}

TEST(LyapunovSum, IsMinusInfiniteWhereADirectionEnds) {
  LyapunovSum sum(2, 2);
  Eigen::MatrixXd derivative(2, 2);
  derivative << 0.5, 0.0, 0.0, 0.0;
  for (int n = 0; n < 30; ++n) sum.take(derivative * sum.frame());
  EXPECT_NEAR(sum.exponents()[0].value, std::log(0.5), 1e-14);
  EXPECT_EQ(sum.exponents()[1].value, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace signorini::lyapunov_test
