#include "problems/assembly/elements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace signorini::elements_test {
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

TEST(NearestFreeNodes, AreOneOnEitherSideWhereThereAre) {
  const std::vector<bool> contact{false, true, true, false, false};
  EXPECT_EQ(nearest_free_nodes(contact, 1), std::pair(0, 3));
  EXPECT_EQ(nearest_free_nodes(contact, 2), std::pair(0, 3));
}

TEST(NearestFreeNodes, AreTwoOnOneSideAtAnEnd) {
  EXPECT_EQ(nearest_free_nodes({false, false, true}, 2), std::pair(1, 0));
  EXPECT_EQ(nearest_free_nodes({true, true, false, false}, 0), std::pair(2, 3));
}

TEST(NearestFreeNodes, SayWhereThereAreFewer) {
  EXPECT_EQ(nearest_free_nodes({false, true}, 1), std::pair(0, -1));
  EXPECT_EQ(nearest_free_nodes({true, true}, 0), std::pair(-1, -1));
}

// Three bar elements; the last node follows the two before it by linear extrapolation, u_3 = 2 u_2 - u_1.
TEST(Redistributed, KeepsTheMomentsOfTheMassThatItsRuleReproduces) {
  Eigen::Matrix4d M;
  M << 2, 1, 0, 0, 1, 4, 1, 0, 0, 1, 4, 1, 0, 0, 1, 2;
  const SparseMatrix moved =
      redistributed(SparseMatrix(M.sparseView()), {{.dof = 3, .leaders = {{2, 2.0}, {1, -1.0}}}});
  const Eigen::Matrix4d R(moved);
  EXPECT_EQ(R.row(3), Eigen::RowVector4d::Zero()) << "the follower carries no mass";
  EXPECT_EQ(R, R.transpose());
  const Eigen::Vector4d one = Eigen::Vector4d::Ones(), place(0, 1, 2, 3);
  EXPECT_NEAR(one.dot(R * one), one.dot(M * one), 1e-14);
  EXPECT_NEAR(one.dot(R * place), one.dot(M * place), 1e-14);
  EXPECT_NEAR(place.dot(R * place), place.dot(M * place), 1e-13);
  // Of no other motion: the second moment of squares changes.
  const Eigen::Vector4d square(0, 1, 4, 9);
  EXPECT_GT(std::abs(square.dot(R * square) - square.dot(M * square)), 1.0);
}

TEST(Redistributed, WithoutFollowersIsTheMassItself) {
  const SparseMatrix M = Eigen::MatrixXd(Eigen::Vector2d(1.0, 3.0).asDiagonal()).sparseView();
  EXPECT_EQ(Eigen::MatrixXd(redistributed(M, {})), Eigen::MatrixXd(M));
}

}  // namespace
}  // namespace signorini::elements_test
