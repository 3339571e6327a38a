#include "problems/assembly/element_row.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace signorini {
namespace {

TEST(SumOfElements, AddsWhereElementsMeet) {
  Eigen::Matrix2d element;
  element << 1.0, -2.0, -2.0, 5.0;
  Eigen::Matrix3d sum;
  sum << 1.0, -2.0, 0.0, -2.0, 6.0, -2.0, 0.0, -2.0, 5.0;
  EXPECT_EQ(Eigen::MatrixXd(sum_of_elements(2, element)), sum);
}

TEST(SumOfElements, KeepsTheCoordinatesOfANodeTogether) {
  Eigen::Matrix4d element = Eigen::Matrix4d::Zero();
  element(0, 3) = element(3, 0) = 7.0;  // first coordinate of the left node, second of the right one
  const Eigen::MatrixXd sum(sum_of_elements(3, element));
  ASSERT_EQ(sum.rows(), 8);
  EXPECT_EQ(sum(0, 3), 7.0);
  EXPECT_EQ(sum(2, 5), 7.0);
  EXPECT_EQ(sum(7, 4), 7.0);
  EXPECT_EQ(sum.sum(), 6 * 7.0);
}

TEST(BlockDiagonal, SetsMatricesSideBySide) {
  const SparseMatrix a = Eigen::MatrixXd(Eigen::Matrix2d::Constant(3.0)).sparseView();
  const SparseMatrix b = Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, 4.0)).sparseView();
  Eigen::Matrix3d both;
  both << 3, 3, 0, 3, 3, 0, 0, 0, 4;
  EXPECT_EQ(Eigen::MatrixXd(block_diagonal({a, b})), both);
}

TEST(Clamped, LeavesTheFirstCoordinatesOut) {
  Eigen::Matrix3d A;
  A << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  EXPECT_EQ(Eigen::MatrixXd(clamped(SparseMatrix(A.sparseView()), 1)), A.bottomRightCorner(2, 2));
}

}  // namespace
}  // namespace signorini
