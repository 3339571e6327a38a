#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini::complex_modes_test {
namespace {

using Complex = std::complex<double>;

EnergyForm one_mass(double m, double d, double k) {
  const auto matrix = [](double value) { return ExtendedMatrix(ExtendedMatrix::Constant(1, 1, value)); };
  return EnergyForm(matrix(m), matrix(d), matrix(k), 1.0);
}

TEST(ComplexModes, OfOneMassAreItsPairOfEigenvalues) {
  const double m = 2.0, d = 0.3, k = 5.0;
  const auto modes = complex_modes(one_mass(m, d, k));
  ASSERT_TRUE(modes);
  ASSERT_EQ(modes->mu.size(), 1);
  EXPECT_EQ(modes->weight[0], 2.0);
  const double decay = 0.5 * d / m;
  EXPECT_LT(std::abs(modes->mu[0] - Complex(-decay, std::sqrt(k / m - decay * decay))), 1e-15);
  // The mode that carries (q, q') = (1, 0) and (0, 1) sums up to them.
  for (int column = 0; column < 2; ++column) {
    const Complex a = modes->left(0, column);
    EXPECT_NEAR((2.0 * modes->shapes(0, 0) * a).real(), column == 0 ? 1.0 : 0.0, 1e-15);
    EXPECT_NEAR((2.0 * modes->mu[0] * modes->shapes(0, 0) * a).real(), column == 1 ? 1.0 : 0.0, 1e-15);
  }
}

TEST(ComplexModes, OfAnOverdampedMassAreTwoRealOnes) {
  const auto modes = complex_modes(one_mass(1.0, 5.0, 4.0));  // mu^2 + 5 mu + 4 = 0
  ASSERT_TRUE(modes);
  ASSERT_EQ(modes->mu.size(), 2);
  EXPECT_EQ(modes->weight, Eigen::Vector2d::Ones());
  EXPECT_NEAR(modes->mu.real().maxCoeff(), -1.0, 1e-15);
  EXPECT_NEAR(modes->mu.real().minCoeff(), -4.0, 1e-14);
}

TEST(ComplexModes, ForcedAmplitudesSolveTheDynamicStiffness) {
  const Eigen::Matrix2d M = Eigen::Vector2d(1.0, 3.0).asDiagonal();
  const Eigen::Matrix2d K = (Eigen::Matrix2d() << 5.0, -2.0, -2.0, 4.0).finished();
  const Eigen::Matrix2d D = (Eigen::Matrix2d() << 0.4, 0.0, 0.0, 0.01).finished();
  const auto modes =
      complex_modes(EnergyForm(M.cast<long double>(), D.cast<long double>(), K.cast<long double>(), 1.0));
  ASSERT_TRUE(modes);
  const Eigen::Vector2cd load(Complex(1.0, -0.5), Complex(0.2, 2.0));
  for (const double rate : {0.0, 0.9, 7.0}) {
    const Eigen::Matrix2cd Z = (K - rate * rate * M).cast<Complex>() + Complex(0.0, rate) * D.cast<Complex>();
    const Eigen::Vector2cd expected = Z.inverse() * load;
    EXPECT_LT((modes->forced(load, rate) - expected).norm(), 1e-14 * (1.0 + expected.norm())) << rate;
  }
}

TEST(ComplexModes, AreNoneWhereTheyAreIllConditioned) {
  EXPECT_FALSE(complex_modes(one_mass(1.0, 2.0, 1.0)));   // critical damping: one vector for two eigenvalues
  EXPECT_FALSE(complex_modes(one_mass(1.0, 0.0, 0.0)));   // a rigid-body motion
  EXPECT_FALSE(complex_modes(one_mass(1.0, 0.1, -2.0)));  // K + s^2 M is not definite
}

}  // namespace
}  // namespace signorini::complex_modes_test
