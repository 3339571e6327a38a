#include "problems/linear_algebra/sparse/sparse_products.hpp"

#include <gtest/gtest.h>

#include <random>

namespace signorini::sparse_products_test {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

// A third of the entries.
Eigen::MatrixXd scattered(Index rows, Index columns, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::MatrixXd result(rows, columns);
  for (double& value : result.reshaped())
    value = random() % 3 == 0 ? static_cast<double>(random() % 1000) / 100.0 - 5.0 : 0.0;
  return result;
}

// sum_k A(i, k) B(k, j), term by term.
Eigen::MatrixXd summed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(A.rows(), B.cols());
  for (Index j = 0; j < B.cols(); ++j)
    for (Index i = 0; i < A.rows(); ++i)
      for (Index k = 0; k < A.cols(); ++k) result(i, j) += A(i, k) * B(k, j);
  return result;
}

double distance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() ? (a - b).cwiseAbs().maxCoeff() : 1.0;
}

constexpr double kRounding = 1e-12;  // of sums of 12 terms up to 25

TEST(SparseProducts, AreSumsTermByTerm) {
  const Eigen::MatrixXd A = scattered(9, 12, 1), B = scattered(12, 5, 2), C = scattered(9, 5, 3),
                        D = scattered(4, 9, 4);
  const Sparse a = A.sparseView(), b = B.sparseView(), c = C.sparseView();
  const Eigen::MatrixXd At = A.transpose();
  EXPECT_LE(distance(sparse_product(a, B), summed(A, B)), kRounding);
  EXPECT_LE(distance(product_by_rows(a, B), summed(A, B)), kRounding);
  EXPECT_LE(distance(Eigen::MatrixXd(sparse_product(a, b)), summed(A, B)), kRounding);
  EXPECT_LE(distance(sparse_product_of_transposed(a, C), summed(At, C)), kRounding);
  EXPECT_LE(distance(Eigen::MatrixXd(sparse_product_of_transposed(a, c)), summed(At, C)), kRounding);
  EXPECT_LE(distance(product_by_sparse(D, a), summed(D, A)), kRounding);
  EXPECT_LE(distance(sparse_image(a, B.col(1)), summed(A, B.col(1))), kRounding);
  EXPECT_LE(distance(sparse_image_by_transposed(a, C.col(1)), summed(At, C.col(1))), kRounding);
  Eigen::VectorXd y = C.col(0);
  subtract_sparse_image(a, B.col(1), y);
  EXPECT_LE(distance(y, C.col(0) - summed(A, B.col(1))), kRounding);
}

TEST(SparseProducts, SumsHaveTheEntriesOfEither) {
  const Eigen::MatrixXd A = scattered(8, 8, 1), B = scattered(8, 8, 2);
  const Sparse sum = sparse_sum(2.0, A.sparseView(), -0.5, B.sparseView());
  EXPECT_LE(distance(Eigen::MatrixXd(sum), 2.0 * A - 0.5 * B), kRounding);
  EXPECT_EQ(sum.nonZeros(), ((A.array() != 0.0) || (B.array() != 0.0)).count());
}

TEST(SparseProducts, ColumnsAreThoseOfTheMatrix) {
  const Eigen::MatrixXd A = scattered(6, 9, 1);
  EXPECT_EQ(Eigen::MatrixXd(sparse_columns(A.sparseView(), 2, 4)), Eigen::MatrixXd(A.middleCols(2, 4)));
  EXPECT_EQ(sparse_columns(A.sparseView(), 9, 0).cols(), 0);
}

}  // namespace
}  // namespace signorini::sparse_products_test
