#include "methods/discretisation/trajectories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace signorini::trajectories_test {
namespace {

FourierTrajectory::Data some_series() {
  FourierTrajectory::Data data;
  data.period = 2.5;
  data.x.resize(6, 2);
  data.lambda.resize(6, 2);
  for (int n = 0; n < 6; ++n) {
    for (int c = 0; c < 2; ++c) {
      data.x(n, c) = std::polar(1.0 / (1 + n * n), n == 0 ? 0.0 : 1.0 + n + 2.0 * c);
      data.lambda(n, c) = std::polar(1.0 / (1 + n), n == 0 ? 0.0 : 0.3 * n - c);
    }
  }
  data.gap = Eigen::Vector2d(0.2, -0.1);
  data.stiffness = Eigen::Vector2d(3.0, 5.0);
  data.multiplier_weight = Eigen::Vector2d(1.0, 0.4);
  return data;
}

double direct_sum(const Eigen::VectorXcd& coefficients, double phase, bool rate) {
  double sum = rate ? 0.0 : coefficients[0].real();
  for (int n = 1; n < coefficients.size(); ++n) {
    const std::complex<double> term = coefficients[n] * std::polar(1.0, n * phase);
    sum += 2.0 * (rate ? (std::complex<double>(0.0, n) * term).real() : term.real());
  }
  return sum;
}

class FourierTrajectorySampled : public testing::TestWithParam<int> {};

TEST_P(FourierTrajectorySampled, EqualsDirectSumsHoweverCoarse) {
  const int count = GetParam();
  const auto data = some_series();
  const Samples samples = FourierTrajectory(data).sample(count);
  for (int i = 0; i < count; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / count;
    for (int c = 0; c < 2; ++c) {
      const double x = direct_sum(data.x.col(c), phase, false);
      const double lambda = direct_sum(data.lambda.col(c), phase, false);
      EXPECT_NEAR(samples.x(i, c), x, 1e-13);
      EXPECT_NEAR(samples.velocity(i, c),
                  2.0 * std::numbers::pi / 2.5 * direct_sum(data.x.col(c), phase, true), 1e-12);
      const double y = data.stiffness[c] * (x - data.gap[c]) - data.multiplier_weight[c] * lambda;
      EXPECT_NEAR(samples.force(i, c), -std::max(0.0, y), 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, FourierTrajectorySampled, testing::Values(1, 2, 3, 5, 10, 11, 64));

TEST(NodalTrajectory, JoinsItsNodesByStraightLines) {
  Eigen::MatrixXd x(4, 1);
  Eigen::MatrixXd force(4, 1);
  x << 0.0, 1.0, 4.0, 3.0;
  force << 0.0, -2.0, 0.0, -6.0;
  const Samples samples = NodalTrajectory(2.0, x, force).sample(8);
  EXPECT_DOUBLE_EQ(samples.x(1, 0), 0.5);
  EXPECT_DOUBLE_EQ(samples.x(2, 0), 1.0);
  EXPECT_DOUBLE_EQ(samples.x(7, 0), 1.5);  // between the last node and the first
  EXPECT_DOUBLE_EQ(samples.velocity(3, 0), 6.0);
  EXPECT_DOUBLE_EQ(samples.force(1, 0), -1.0);
  EXPECT_DOUBLE_EQ(samples.force(7, 0), -3.0);
}

TEST(NodalTrajectory, SampledAtItsOwnNodesKeepsTheImpulse) {
  const Eigen::MatrixXd x = Eigen::MatrixXd::Zero(5, 1);
  Eigen::MatrixXd force(5, 1);
  force << 0.0, -1.0, -3.0, 0.0, 0.0;
  const NodalTrajectory trajectory(1.5, x, force);
  EXPECT_NEAR(1.5 * trajectory.sample(5).force.mean(), 1.5 / 5 * -4.0, 1e-15);
  EXPECT_NEAR(1.5 * trajectory.sample(50).force.mean(), 1.5 / 5 * -4.0, 1e-15);
}

}  // namespace
}  // namespace signorini::trajectories_test
