#include "methods/linear_flow/modes/complex_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <optional>
#include <vector>

#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini::complex_modes_test {
namespace {

using Complex = std::complex<double>;

constexpr double kRate = 1.0;

std::optional<ComplexModes> modes_of(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D,
                                     const Eigen::MatrixXd& K) {
  return complex_modes({extended::widened(M), extended::widened(D), extended::widened(K)}, kRate);
}

std::optional<ComplexModes> one_mass(double m, double d, double k) {
  const auto matrix = [](double value) { return Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, value)); };
  return modes_of(matrix(m), matrix(d), matrix(k));
}

TEST(ComplexModes, OfOneMassAreItsPairOfEigenvalues) {
  const double m = 2.0, d = 0.3, k = 5.0;
  const auto modes = one_mass(m, d, k);
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
  const auto modes = one_mass(1.0, 5.0, 4.0);  // mu^2 + 5 mu + 4 = 0
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
  const auto modes = modes_of(M, D, K);
  ASSERT_TRUE(modes);
  const Eigen::Vector2cd load(Complex(1.0, -0.5), Complex(0.2, 2.0));
  for (const double rate : {0.0, 0.9, 7.0}) {
    const Eigen::Matrix2cd Z = (K - rate * rate * M).cast<Complex>() + Complex(0.0, rate) * D.cast<Complex>();
    const Eigen::Vector2cd expected = Z.inverse() * load;
    EXPECT_LT((modes->forced(load, rate) - expected).norm(), 1e-14 * (1.0 + expected.norm())) << rate;
  }
}

// Masses 1 in a row, the first on the ground: K has 2, -1, and 1 at the free end.
Eigen::MatrixXd chain_stiffness(int n) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  K.diagonal().setConstant(2.0);
  K(n - 1, n - 1) = 1.0;
  K.diagonal(1).setConstant(-1.0);
  K.diagonal(-1).setConstant(-1.0);
  return K;
}

TEST(ComplexModes, OfAProportionallyDampedChainAreInClosedForm) {
  // Frequencies 2 sin((2k - 1) pi / (4n + 2)); with D = b K modes of b w^2 > 2 w are two real ones.
  for (const int n : {1, 2, 10, 40}) {
    for (const double b : {0.0, 0.2, 1.7}) {
      const Eigen::MatrixXd K = chain_stiffness(n);
      const auto modes = modes_of(Eigen::MatrixXd::Identity(n, n), b * K, K);
      ASSERT_TRUE(modes);
      std::vector<Complex> expected;
      for (int k = 1; k <= n; ++k) {
        const double w = 2.0 * std::sin((2.0 * k - 1.0) * std::numbers::pi / (4.0 * n + 2.0)), d = b * w * w;
        const Complex root = std::sqrt(Complex(0.25 * d * d - w * w));
        expected.push_back(-0.5 * d + root);
        if (root.real() > 0.0) expected.push_back(-0.5 * d - root);
      }
      ASSERT_EQ(modes->mu.size(), std::ssize(expected)) << n << " masses, b = " << b;
      for (const Complex mu : expected)
        EXPECT_LT((modes->mu.array() - mu).abs().minCoeff(), 1e-13 * std::abs(mu))
            << n << " masses, b = " << b;
    }
  }
}

// What (q, q') = Re sum w (U, mu U) left says of a state is that state; and mu (U, mu U) is what the
// structure makes of it.
void expect_motions_of(const ComplexModes& modes, const Eigen::MatrixXd& M, const Eigen::MatrixXd& D,
                       const Eigen::MatrixXd& K, double bound) {
  const Eigen::Index n = M.rows();
  Eigen::MatrixXcd states(2 * n, modes.mu.size());
  states << modes.shapes, modes.shapes * modes.mu.asDiagonal();
  const Eigen::MatrixXd identity = (states * modes.weight.asDiagonal() * modes.left).real();
  EXPECT_LT((identity - Eigen::MatrixXd::Identity(2 * n, 2 * n)).norm(), bound);
  for (Eigen::Index k = 0; k < modes.mu.size(); ++k) {
    const Complex mu = modes.mu[k];
    const Eigen::MatrixXcd Z = (mu * mu * M + mu * D + K.cast<Complex>());
    EXPECT_LT((Z * modes.shapes.col(k)).norm(), bound * K.norm() * modes.shapes.col(k).norm())
        << "mode " << k;
  }
  const Eigen::MatrixXd of_impulse = (states * modes.weight.asDiagonal() * modes.of_load).real();
  EXPECT_LT(of_impulse.topRows(n).norm(), bound);
  EXPECT_LT((of_impulse.bottomRows(n) * M - Eigen::MatrixXd::Identity(n, n)).norm(), bound);
}

TEST(ComplexModes, MoveTheStructureWhateverItsDamping) {
  const int n = 6;
  // Masses that share rods: L of M is no diagonal matrix.
  const Eigen::MatrixXd K = chain_stiffness(n);
  const Eigen::MatrixXd M = Eigen::VectorXd::LinSpaced(n, 1.0, 3.0).asDiagonal().toDenseMatrix() - K / 6.0;
  Eigen::MatrixXd circulatory = K;
  circulatory(0, 3) += 0.1;
  Eigen::MatrixXd gyroscopic = 0.01 * K;
  gyroscopic(1, 4) += 0.3;
  gyroscopic(4, 1) -= 0.3;
  for (const double overdamped : {0.1, 1.3}) {
    expect_motions_of(*modes_of(M, overdamped * K + 0.02 * M, K), M, overdamped * K + 0.02 * M, K, 1e-13);
    const Eigen::MatrixXd one_damper = overdamped * Eigen::VectorXd::Unit(n, 2).asDiagonal().toDenseMatrix();
    expect_motions_of(*modes_of(M, one_damper, K), M, one_damper, K, 1e-13);
  }
  expect_motions_of(*modes_of(M, gyroscopic, K), M, gyroscopic, K, 1e-13);
  expect_motions_of(*modes_of(M, 0.1 * K, circulatory), M, 0.1 * K, circulatory, 1e-13);
  // Equal masses on equal springs have one frequency, whose shapes the damper of one of them chooses.
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd one_damper = 0.2 * Eigen::VectorXd::Unit(n, 2).asDiagonal().toDenseMatrix();
  const Eigen::MatrixXd turned = householder_basis(K + M);
  const Eigen::MatrixXd D = turned * one_damper * turned.transpose();
  expect_motions_of(*modes_of(I, 0.5 * (D + D.transpose()), 3.0 * I), I, 0.5 * (D + D.transpose()), 3.0 * I,
                    1e-13);
}

TEST(ComplexModes, MoveAStructureOfManyCoordinates) {
  const int n = 16;
  const Eigen::MatrixXd K = chain_stiffness(n);
  const Eigen::MatrixXd M = Eigen::VectorXd::LinSpaced(n, 1.0, 3.0).asDiagonal().toDenseMatrix() - K / 6.0;
  for (const double damper : {0.1, 30.0}) {  // the latter overdamped
    const Eigen::MatrixXd D = 0.01 * K + damper * Eigen::VectorXd::Unit(n, 2).asDiagonal().toDenseMatrix();
    const auto modes = modes_of(M, D, K);
    ASSERT_TRUE(modes);
    EXPECT_EQ(modes->mu.size(), damper > 1.0 ? n + 1 : n);
    expect_motions_of(*modes, M, D, K, 1e-12);
  }
}

TEST(ComplexModes, AreRealShapesWhereDampingCouplesNone) {
  const int n = 10;
  const Eigen::MatrixXd K = chain_stiffness(n), I = Eigen::MatrixXd::Identity(n, n);
  const auto imaginary = [&](const Eigen::MatrixXd& D) {
    const Eigen::MatrixXcd shapes = modes_of(I, D, K)->shapes;
    return shapes.imag().norm() / shapes.norm();
  };
  EXPECT_EQ(imaginary(0.1 * K), 0.0);
  EXPECT_EQ(imaginary(0.1 * I), 0.0);
  EXPECT_GT(imaginary(0.1 * Eigen::VectorXd::Unit(n, 0).asDiagonal().toDenseMatrix()), 1e-3);
  const Eigen::MatrixXd many = chain_stiffness(40);  // whose frequencies spread fiftyfold
  const auto modes =
      modes_of(Eigen::MatrixXd::Identity(40, 40), 0.3 * Eigen::MatrixXd::Identity(40, 40) + 0.1 * many, many);
  ASSERT_TRUE(modes);
  EXPECT_EQ(modes->shapes.imag().norm(), 0.0);
  // Coupling far below the damping itself, but above its rounding, is kept.
  Eigen::MatrixXd D = 0.1 * K;
  D(0, 1) += 1e-13;
  D(1, 0) += 1e-13;
  EXPECT_GT(imaginary(D), 0.0);
}

TEST(ComplexModes, AreKeptUpToAThousandFromCriticalDamping) {
  // The condition is about 1 / sqrt(1 - zeta^2) near zeta = 1.
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(one_mass(1.0, 2.0 * (1.0 + side * 1e-5), 1.0));
    EXPECT_FALSE(one_mass(1.0, 2.0 * (1.0 + side * 1e-7), 1.0));
  }
}

TEST(ComplexModes, GrowWhereDampingIsNegative) {
  const auto modes = one_mass(1.0, -0.2, 1.0);
  ASSERT_TRUE(modes);
  EXPECT_LT(std::abs(modes->mu[0] - Complex(0.1, std::sqrt(0.99))), 1e-15);
  const auto overdamped = one_mass(1.0, -2.5, 1.0);  // mu^2 - 2.5 mu + 1 = 0
  ASSERT_TRUE(overdamped);
  EXPECT_NEAR(overdamped->mu.real().minCoeff(), 0.5, 1e-15);
  EXPECT_NEAR(overdamped->mu.real().maxCoeff(), 2.0, 1e-15);
}

TEST(ComplexModes, AreNoneWhereTheyAreIllConditioned) {
  EXPECT_FALSE(one_mass(1.0, 2.0, 1.0));   // critical damping: one vector for two eigenvalues
  EXPECT_FALSE(one_mass(1.0, 0.0, 0.0));   // a rigid-body motion
  EXPECT_FALSE(one_mass(1.0, 0.1, -2.0));  // K + s^2 M is not definite
}

}  // namespace
}  // namespace signorini::complex_modes_test
