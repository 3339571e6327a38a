#include "methods/solvers/anderson_acceleration.hpp"

#include <gtest/gtest.h>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::anderson_acceleration_test {
namespace {

struct AffineMap {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;

  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return A * x + b; }
  [[nodiscard]] Eigen::VectorXd fixed_point() const {
    return lu_solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()) - A, b);
  }
};

/// Where so many iterates from zero lead.
Eigen::VectorXd iterate(const AffineMap& map, int depth, int steps) {
  AndersonAcceleration acceleration(depth);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(map.b.size());
  for (int k = 0; k < steps; ++k) x = acceleration.next(x, map(x));
  return x;
}

// Eigenvalues 1.7, -2.5, 0.9, 0.2: the map itself diverges.
TEST(AndersonAcceleration, SolvesAnAffineMapInAsManyStepsAsItHasEigenvalues) {
  AffineMap map{.A = Eigen::Vector4d(1.7, -2.5, 0.9, 0.2).asDiagonal(),
                .b = Eigen::Vector4d(1.0, 2.0, -1.0, 3.0)};
  map.A(0, 3) = 0.5;
  map.A(2, 1) = -1.5;
  EXPECT_LE((iterate(map, 4, 6) - map.fixed_point()).norm(), 1e-9 * map.fixed_point().norm());
  EXPECT_GT((iterate(map, 0, 40) - map.fixed_point()).norm(), 1e6);
}

TEST(AndersonAcceleration, OfDepthZeroIsTheMapItself) {
  const AffineMap map{.A = Eigen::Matrix2d::Identity() * 0.5, .b = Eigen::Vector2d(1.0, -1.0)};
  EXPECT_EQ(iterate(map, 0, 3), Eigen::Vector2d(1.75, -1.75));
}

// A map that has arrived has no differences left to use.
TEST(AndersonAcceleration, StaysAtTheFixedPoint) {
  const AffineMap map{.A = Eigen::Matrix2d::Zero(), .b = Eigen::Vector2d(1.0, 2.0)};
  EXPECT_EQ(iterate(map, 3, 5), Eigen::Vector2d(1.0, 2.0));
}

}  // namespace
}  // namespace signorini::anderson_acceleration_test
