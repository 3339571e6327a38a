#include "methods/solvers/dense_products.hpp"

#include <gtest/gtest.h>

namespace signorini::dense_products_test {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::Random(rows, columns);
}

// Small ones, and such as go to the BLAS.
class DenseProducts : public testing::TestWithParam<Eigen::Index> {};

TEST_P(DenseProducts, EqualThoseOfGenericCode) {
  std::srand(5);
  const Eigen::Index m = 7 * GetParam(), k = 4 * GetParam(), n = 5 * GetParam();
  const double tolerance = 1e-15 * static_cast<double>(k);
  const Eigen::MatrixXd A = random_matrix(m, k), B = random_matrix(k, n), tall = random_matrix(m, 3);
  EXPECT_LT((dense_product(A, B) - A.lazyProduct(B)).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((transposed_product(A, tall) - A.transpose().lazyProduct(tall)).cwiseAbs().maxCoeff(), tolerance);
  const Eigen::MatrixXcd Z = Eigen::MatrixXcd::Random(k, 6);
  EXPECT_LT((dense_product(A, Z) - A.cast<std::complex<double>>().lazyProduct(Z)).cwiseAbs().maxCoeff(),
            tolerance);
  const Eigen::VectorXcd d = Eigen::VectorXcd::Random(k);
  const Eigen::MatrixXcd scaled = d.asDiagonal() * B.cast<std::complex<double>>();
  EXPECT_LT(
      (scaled_product(A, d, B) - A.cast<std::complex<double>>().lazyProduct(scaled)).cwiseAbs().maxCoeff(),
      tolerance);
  Eigen::MatrixXd C = random_matrix(m, n);
  const Eigen::MatrixXd expected = C - A.lazyProduct(B);
  subtract_product(A, B, C);
  EXPECT_LT((C - expected).cwiseAbs().maxCoeff(), tolerance);
}

INSTANTIATE_TEST_SUITE_P(SmallAndLarge, DenseProducts, testing::Values(1, 10));

TEST(DenseProductsOfNothing, AreZero) {
  const Eigen::MatrixXd none(3, 0), nothing(0, 2);
  EXPECT_EQ(dense_product(none, nothing), Eigen::MatrixXd::Zero(3, 2));
  EXPECT_EQ(transposed_product(nothing, Eigen::MatrixXd(0, 4)), Eigen::MatrixXd::Zero(2, 4));
  EXPECT_EQ(dense_product(random_matrix(0, 3), random_matrix(3, 2)).rows(), 0);
  Eigen::MatrixXd kept = Eigen::MatrixXd::Ones(3, 2);
  subtract_product(none, nothing, kept);
  EXPECT_EQ(kept, Eigen::MatrixXd::Ones(3, 2));
}

}  // namespace
}  // namespace signorini::dense_products_test
