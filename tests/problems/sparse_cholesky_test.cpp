#include "problems/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::sparse_cholesky_test {
namespace {

/// Springs of 1 N/m between n masses in a row and to the walls on both sides.
SparseMatrix springs(int size) {
  SparseMatrix K(size, size);
  for (int i = 0; i < size; ++i) {
    K.insert(i, i) = 2.0;
    if (i == 0) continue;
    K.insert(i, i - 1) = -1.0;
    K.insert(i - 1, i) = -1.0;
  }
  return K;
}

// A force of 1 N on mass j deflects mass i by min(i, j) (n + 1 - max(i, j)) / (n + 1).
TEST(SparseCholesky, SolvesAChainInClosedForm) {
  for (const int size : {1, 7, 5000}) {
    SparseCholesky factors(springs(size));
    const int loaded = size / 3;
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(size, 2);
    load(loaded, 0) = 1.0;
    load(size - 1, 1) = -2.0;
    const Eigen::MatrixXd u = factors.solve(load);
    const auto deflection = [&](int i, int j) {
      return (std::min(i, j) + 1.0) * (size - std::max(i, j)) / (size + 1.0);
    };
    for (int i = 0; i < size; i += 1 + size / 10) {
      EXPECT_NEAR(u(i, 0), deflection(i, loaded), 1e-9 * size) << i << " of " << size;
      EXPECT_NEAR(u(i, 1), -2.0 * deflection(i, size - 1), 1e-9 * size) << i << " of " << size;
    }
    EXPECT_GE(factors.entries(), 2 * size - 1) << "as many as the lower triangle at least";
    EXPECT_GE(factors.operations(), size);
  }
}

TEST(SparseCholesky, SolvesForMoreColumnsThanItTakesAtOnce) {
  constexpr int kSize = 150;
  SparseCholesky factors(springs(kSize));
  const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(kSize, kSize));
  EXPECT_LT((springs(kSize) * inverse - Eigen::MatrixXd::Identity(kSize, kSize)).cwiseAbs().maxCoeff(),
            1e-10);
}

TEST(SparseCholesky, CountsItsOperationsBeforeItDoesThem) {
  for (const int size : {7, 5000}) {
    const SparseCholesky::Cost cost = SparseCholesky::cost_of(springs(size));
    EXPECT_EQ(cost.operations, SparseCholesky(springs(size)).operations());
    EXPECT_GE(cost.entries, 2.0 * size - 1.0);
    EXPECT_LE(cost.entries, SparseCholesky(springs(size)).entries());
  }
}

TEST(SparseCholesky, LooksAtTheLowerTriangleOnly) {
  SparseMatrix K = springs(6);
  for (int i = 1; i < 6; ++i) K.coeffRef(i - 1, i) = 100.0;
  const Eigen::VectorXd u = SparseCholesky(K).solve(Eigen::VectorXd::Unit(6, 0));
  EXPECT_NEAR(u[0], 6.0 / 7.0, 1e-14);
}

TEST(SparseCholesky, HasNoPositivePivotWhereTheMatrixIsNotDefinite) {
  EXPECT_GT(SparseCholesky(springs(100)).smallest_pivot(), 0.0);
  EXPECT_LE(SparseCholesky(springs(100)).smallest_pivot(), 1.0);
  SparseMatrix indefinite = springs(100);
  indefinite.coeffRef(40, 40) = 0.1;
  EXPECT_LE(SparseCholesky(indefinite).smallest_pivot(), 0.0);
}

TEST(SparseCholesky, LeavesAnEmptyRightSideEmpty) {
  SparseCholesky factors(springs(3));
  EXPECT_EQ(factors.solve(Eigen::MatrixXd(3, 0)).cols(), 0);
}

}  // namespace
}  // namespace signorini::sparse_cholesky_test
