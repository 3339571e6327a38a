// Modes with springs to the ground from those without, against those of the whole matrices.

#include "methods/linear_flow/modes/spring_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "methods/linear_flow/modes/complex_modes.hpp"

namespace signorini::spring_modes_test {
namespace {

constexpr double kRate = 1.0;
constexpr int kSize = 18;

Eigen::MatrixXd mass() { return Eigen::VectorXd::LinSpaced(kSize, 1.0, 3.0).asDiagonal().toDenseMatrix(); }

// Of a clamped beam of small elements: frequencies over three decades.
Eigen::MatrixXd stiffness() {
  Eigen::MatrixXd chain = 2.0 * Eigen::MatrixXd::Identity(kSize, kSize);
  chain.diagonal(1).setConstant(-1.0);
  chain.diagonal(-1).setConstant(-1.0);
  return 1e4 * chain * chain;
}

std::optional<ComplexModes> dense_modes(const Eigen::MatrixXd& D, const Eigen::MatrixXd& K) {
  return complex_modes({extended::widened(mass()), extended::widened(D), extended::widened(K)}, kRate);
}

// What a time makes of (q, q') on q: Re sum_k w_k U_k e^{mu_k t} left_k.
Eigen::MatrixXd moved(const ComplexModes& modes, double time) {
  const Eigen::VectorXcd growth = (modes.mu * time).array().exp() * modes.weight.array();
  return (modes.shapes * growth.asDiagonal() * modes.left).real();
}

GroundedSprings springs(double factor) {
  GroundedSprings made{.directions = Eigen::MatrixXd::Zero(kSize, 3),
                       .stiffness = factor * Eigen::Vector3d(300.0, 5e4, 2.0),
                       .damping = factor * Eigen::Vector3d(0.0, 0.5, 0.1)};
  made.directions(4, 0) = made.directions(17, 2) = 1.0;
  made.directions(9, 1) = -1.0;
  return made;
}

// Damping by which all modes are pairs, with springs stiffer than the structure, and by which the fastest are
// overdamped, with soft ones: stiff ones couple those strongly.
TEST(SpringModes, AreThoseOfTheWholeMatrices) {
  for (const auto& [beta, factor] : {std::pair(1e-5, 1.0), std::pair(8e-3, 1e-3)}) {
    const Eigen::MatrixXd K = stiffness(), D = 0.15 * mass() + beta * K;
    const GroundedSprings added = springs(factor);
    const auto without = dense_modes(D, K);
    ASSERT_TRUE(without);
    const SparseMatrix M = mass().sparseView();
    const auto modes = modes_with_springs(*without, M, added, kRate);
    const auto dense =
        dense_modes(D + added.directions * added.damping.asDiagonal() * added.directions.transpose(),
                    K + added.directions * added.stiffness.asDiagonal() * added.directions.transpose());
    ASSERT_TRUE(modes && dense);
    EXPECT_EQ(modes->mu.size(), dense->mu.size());
    for (const double time : {0.0, 0.01, 1.0})
      EXPECT_LT((moved(*modes, time) - moved(*dense, time)).norm(), 1e-11 * moved(*dense, time).norm())
          << beta;
    const Eigen::VectorXcd load = Eigen::VectorXd::LinSpaced(kSize, -1.0, 2.0).cast<std::complex<double>>();
    const Eigen::VectorXcd answer = dense->forced(load, 3.0);
    EXPECT_LT((modes->forced(load, 3.0) - answer).norm(), 1e-11 * answer.norm());
  }
}

TEST(SpringModes, AreNoneWhereDampingIsNotProportional) {
  const Eigen::MatrixXd K = stiffness();
  const auto without =
      dense_modes(0.01 * K / 1e4 + 0.1 * Eigen::VectorXd::Unit(kSize, 2).asDiagonal().toDenseMatrix(), K);
  ASSERT_TRUE(without);
  EXPECT_FALSE(modes_with_springs(*without, SparseMatrix(mass().sparseView()), springs(1.0), kRate));
}

}  // namespace
}  // namespace signorini::spring_modes_test
