#include "methods/reduction/principal_directions.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace signorini::principal_directions_test {
namespace {

using Complex = std::complex<double>;

// Three orthogonal motions of mean squares 1, 1e-4 and 1e-10: as many directions as the tolerance asks for,
// the longest last.
TEST(PrincipalDirections, LeaveNoMoreThanTheTolerance) {
  Eigen::MatrixXcd series = Eigen::MatrixXcd::Zero(3, 3);
  series(0, 0) = 1.0;
  series(1, 1) = Complex(0.0, 1e-2 / std::sqrt(2.0));
  series(2, 2) = 1e-5 / std::sqrt(2.0);
  const Eigen::MatrixXd square = mean_square(series, Eigen::Vector3d::Ones());
  EXPECT_NEAR(square.trace(), 1.0001, 1e-9);
  EXPECT_EQ(principal_directions(square, 2.0, 3).cols(), 0);
  EXPECT_EQ(principal_directions(square, 0.1, 3).cols(), 1);
  EXPECT_EQ(principal_directions(square, 1e-3, 3).cols(), 2);
  EXPECT_EQ(principal_directions(square, 1e-3, 1).cols(), 1);
  const Eigen::MatrixXd all = principal_directions(square, 1e-7, 3);
  ASSERT_EQ(all.cols(), 3);
  EXPECT_NEAR(std::abs(all(0, 2)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(all(1, 1)), 1.0, 1e-12);
  EXPECT_EQ(principal_directions(Eigen::MatrixXd(0, 0), 1.0, 3).cols(), 0);
}

// Weights count harmonic by harmonic, and the constant once.
TEST(PrincipalDirections, MeansSquaresOverTime) {
  Eigen::MatrixXcd series(1, 2);
  series << 3.0, Complex(1.0, 2.0);
  EXPECT_NEAR(mean_square(series, Eigen::Vector2d(2.0, 0.5))(0, 0), 36.0 + 2.0 * 0.25 * 5.0, 1e-12);
}

}  // namespace
}  // namespace signorini::principal_directions_test
