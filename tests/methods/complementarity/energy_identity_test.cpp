#include "methods/complementarity/energy_identity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace signorini {
namespace {

using Complex = std::complex<double>;

TEST(NetWorkRatio, SeesAForceInPhaseWithTheVelocity) {
  Eigen::MatrixXcd x(2, 1);
  Eigen::MatrixXcd lambda(2, 1);
  x << 0.0, Complex(1.0, 0.0);
  lambda << 0.0, Complex(0.0, 2.0);
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 1.0);
  lambda(1, 0) = -3.0;
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 0.0);
}

// The integral of lambda x' over a period, by a sum over samples.
TEST(NetWorkRatio, IsTheWorkIntegral) {
  Eigen::MatrixXcd x(3, 1);
  Eigen::MatrixXcd lambda(3, 1);
  x << 0.2, Complex(0.5, 0.1), Complex(-0.2, 0.3);
  lambda << -1.0, Complex(0.4, -0.3), Complex(0.1, 0.6);
  constexpr int kSamples = 64;
  double work = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    double velocity = 0.0;
    double force = lambda(0, 0).real();
    for (int n = 1; n <= 2; ++n) {
      const Complex turn = std::polar(1.0, 2.0 * std::numbers::pi * n * i / kSamples);
      velocity += 2.0 * (Complex(0.0, 2.0 * std::numbers::pi * n) * x(n, 0) * turn).real();
      force += 2.0 * (lambda(n, 0) * turn).real();
    }
    work += force * velocity / kSamples;
  }
  double exchanged = 0.0;
  for (int n = 1; n <= 2; ++n)
    exchanged += 4.0 * std::numbers::pi * n * std::abs(x(n, 0)) * std::abs(lambda(n, 0));
  EXPECT_NEAR(net_work_ratio(x, lambda), std::abs(work) / exchanged, 1e-14);
}

TEST(NetWorkRatio, IsZeroWithoutForceOrMotion) {
  const Eigen::MatrixXcd some = Eigen::MatrixXcd::Constant(3, 2, Complex(1.0, 1.0));
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(3, 2);
  EXPECT_EQ(net_work_ratio(some, none), 0.0);
  EXPECT_EQ(net_work_ratio(none, some), 0.0);
}

TEST(NetWorkRatio, SumsOverContactsBeforeItTakesTheSize) {
  // What one contact takes from the structure the other gives back.
  Eigen::MatrixXcd x = Eigen::MatrixXcd::Zero(2, 2);
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(2, 2);
  x.row(1) << 1.0, 1.0;
  lambda.row(1) << Complex(0.0, 1.0), Complex(0.0, -1.0);
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 0.0);
}

}  // namespace
}  // namespace signorini
