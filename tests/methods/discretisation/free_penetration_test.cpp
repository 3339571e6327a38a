#include "methods/discretisation/free_penetration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace signorini {
namespace {

/// scale (sum_{|n| <= H} x_n e^{2 pi i n k / N} - gap) by a direct sum over the first `kept` coefficients.
double direct(const Eigen::VectorXcd& x, double gap, double scale, int k, int samples, Eigen::Index kept) {
  double sum = x[0].real();
  for (Eigen::Index n = 1; n < kept; ++n) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(n) * k / samples;
    sum += 2.0 * (x[n] * std::polar(1.0, angle)).real();
  }
  return scale * (sum - gap);
}

TEST(FreePenetration, IsTheScaledDistanceBeyondTheStopAtEveryInstant) {
  constexpr int kSamples = 16;
  Eigen::MatrixXcd response = Eigen::MatrixXcd::Random(5, 2);
  response.row(0) = response.row(0).real().cast<std::complex<double>>();
  const Eigen::Vector2d gap(0.3, -0.1), scale(2.0, 0.5);
  const Eigen::VectorXd penetration = free_penetration(response, gap, scale, kSamples);
  ASSERT_EQ(penetration.size(), 2 * kSamples);
  for (int c = 0; c < 2; ++c) {
    for (int k = 0; k < kSamples; ++k) {
      EXPECT_NEAR(penetration[c * kSamples + k], direct(response.col(c), gap[c], scale[c], k, kSamples, 5),
                  1e-13);
    }
  }
}

TEST(FreePenetration, DropsHarmonicsThatTheGridDoesNotCarry) {
  constexpr int kSamples = 7;  // carries harmonics 0..3
  Eigen::MatrixXcd response = Eigen::MatrixXcd::Random(9, 1);
  response(0, 0) = 0.4;
  const Eigen::VectorXd gap = Eigen::VectorXd::Zero(1), scale = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd penetration = free_penetration(response, gap, scale, kSamples);
  for (int k = 0; k < kSamples; ++k)
    EXPECT_NEAR(penetration[k], direct(response.col(0), 0.0, 1.0, k, kSamples, 4), 1e-13);
}

}  // namespace
}  // namespace signorini
