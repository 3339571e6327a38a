#include "harness/doctor/calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace signorini::calibration_test {
namespace {

/// Amplitude of the last mass without a stop, by elimination along the row: the mass i behind the first i has
/// the dynamic stiffness d = k_i - 1 / (that of the mass before), times (1 + i w beta) of damped springs.
std::complex<double> linear_amplitude() {
  const std::complex<double> i(0.0, 1.0);
  const double w = 0.1;
  const std::complex<double> spring = 1.0 + i * w * 0.2, mass = -w * w + i * w * 0.05;
  std::complex<double> before = mass + 2.0 * spring;
  for (int k = 1; k < 31; ++k) before = mass + 2.0 * spring - spring * spring / before;
  return 1.0 / (mass + spring - spring * spring / before);
}

TEST(CalibrationSolve, FollowsTheLinearResponseWhereItsStopIsFar) {
  const std::vector<double> motion = calibration_solve(100.0);
  ASSERT_EQ(motion.size(), 2000U);
  const std::complex<double> amplitude = linear_amplitude();
  EXPECT_NEAR(std::abs(amplitude), 6.43, 0.01);
  for (int k = 1; k <= 100; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 100.0;
    const double exact = (amplitude * std::polar(1.0, angle)).real();
    // Steps of 1/100 period: the midpoint rule is of order two.
    EXPECT_NEAR(motion[static_cast<std::size_t>(1899 + k)], exact, 2e-3 * std::abs(amplitude)) << k;
  }
}

TEST(CalibrationSolve, StrikesItsStopAndSettles) {
  const std::vector<double> motion = calibration_solve();
  double fastest = 0.0;
  for (std::size_t k = 1; k < motion.size(); ++k)
    fastest = std::max(fastest, std::abs(motion[k] - motion[k - 1]));
  EXPECT_GT(std::ranges::max(motion), kCalibrationGap);
  EXPECT_LT(std::ranges::max(motion), kCalibrationGap + fastest) << "it goes no further than a step behind";
  for (std::size_t k = 1900; k < 2000; ++k) EXPECT_NEAR(motion[k], motion[k - 100], 1e-8);
}

TEST(CalibrationSeconds, AreTheTimeOfASolve) {
  const double seconds = calibration_seconds();
  EXPECT_GT(seconds, 1e-5);
  EXPECT_LT(seconds, 1.0);
}

}  // namespace
}  // namespace signorini::calibration_test
