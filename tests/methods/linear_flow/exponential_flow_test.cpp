#include <gtest/gtest.h>

#include <cmath>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini::exponential_flow_test {
namespace {

TEST(MatrixExponential, OfASkewMatrixIsARotation) {
  for (const double angle : {1e-9, 0.3, 2.0, 40.0}) {
    const Eigen::Matrix2d A = (Eigen::Matrix2d() << 0.0, -angle, angle, 0.0).finished();
    const Eigen::Matrix2d expected =
        (Eigen::Matrix2d() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
    EXPECT_LT((matrix_exponential(A) - expected).norm(), 1e-15 * (4.0 + angle)) << angle;
  }
}

// A mass that sticks leaves no coordinate free.
TEST(MatrixExponential, OfNothingIsNothing) {
  EXPECT_EQ(matrix_exponential(Eigen::MatrixXd(0, 0)).size(), 0);
}

TEST(MatrixExponential, OfANilpotentMatrixIsItsTaylorSum) {
  const Eigen::Matrix3d N = (Eigen::Matrix3d() << 0.0, 2.0, 3.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0).finished();
  const Eigen::Matrix3d expected = Eigen::Matrix3d::Identity() + N + 0.5 * N * N;
  EXPECT_LT((matrix_exponential(N) - expected).norm(), 1e-14);
}

TEST(MatrixExponential, OfADiagonalMatrixActsElementByElement) {
  const Eigen::Vector3d rates(-30.0, 0.0, 2.0);
  const Eigen::MatrixXd result = matrix_exponential(rates.asDiagonal().toDenseMatrix());
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(result(i, i) / std::exp(rates[i]), 1.0, 1e-13);
}

}  // namespace
}  // namespace signorini::exponential_flow_test
