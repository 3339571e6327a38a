#include "methods/solvers/dense_products.hpp"

#include <gtest/gtest.h>

namespace signorini::dense_products_test {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::Random(rows, columns);
}

TEST(DenseProducts, EqualThoseOfGenericCode) {
  std::srand(5);
  const Eigen::MatrixXd A = random_matrix(7, 4), B = random_matrix(4, 5), tall = random_matrix(7, 3);
  EXPECT_LT((dense_product(A, B) - A.lazyProduct(B)).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((transposed_product(A, tall) - A.transpose().lazyProduct(tall)).cwiseAbs().maxCoeff(), 1e-15);
  const Eigen::MatrixXcd Z = Eigen::MatrixXcd::Random(4, 6);
  EXPECT_LT((dense_product(A, Z) - A.cast<std::complex<double>>().lazyProduct(Z)).cwiseAbs().maxCoeff(),
            1e-15);
  const Eigen::VectorXcd d = Eigen::VectorXcd::Random(4);
  const Eigen::MatrixXcd scaled = d.asDiagonal() * B.cast<std::complex<double>>();
  EXPECT_LT(
      (scaled_product(A, d, B) - A.cast<std::complex<double>>().lazyProduct(scaled)).cwiseAbs().maxCoeff(),
      1e-15);
  Eigen::MatrixXd C = random_matrix(7, 5);
  const Eigen::MatrixXd expected = C - A.lazyProduct(B);
  subtract_product(A, B, C);
  EXPECT_LT((C - expected).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(DenseProducts, OfNothingAreZero) {
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
