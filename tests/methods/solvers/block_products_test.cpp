#include "methods/solvers/block_products.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstdlib>
#include <vector>

namespace signorini::block_products_test {
namespace {

/// A B by its definition.
Eigen::MatrixXd summed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(A.rows(), B.cols());
  for (Eigen::Index i = 0; i < C.rows(); ++i) {
    for (Eigen::Index j = 0; j < C.cols(); ++j) {
      for (Eigen::Index k = 0; k < A.cols(); ++k) C(i, j) += A(i, k) * B(k, j);
    }
  }
  return C;
}

double difference(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.size() == 0 && B.size() == 0 ? 0.0 : (A - B).cwiseAbs().maxCoeff();
}

// Small ones are summed as they stand, large ones go through the kernels, single rows and columns by their
// own.
class BlockProducts : public testing::TestWithParam<std::array<Eigen::Index, 3>> {
 protected:
  void SetUp() override { std::srand(7); }
};

TEST_P(BlockProducts, EqualTheirDefinition) {
  const auto [m, k, n] = GetParam();
  const double tolerance = 1e-15 * static_cast<double>(std::max<Eigen::Index>(k, 1));
  const Eigen::MatrixXd around = Eigen::MatrixXd::Random(m + 2, k + 3), B = Eigen::MatrixXd::Random(k, n);
  const Eigen::MatrixXd A = around.block(1, 2, m, k), AB = summed(A, B), transposed = B.transpose();
  const Eigen::VectorXd v = Eigen::VectorXd::Random(k);
  EXPECT_LT(difference(block_product(around.block(1, 2, m, k), B), AB), tolerance);
  EXPECT_LT(difference(times_transposed(A, transposed), AB), tolerance);
  EXPECT_LT(difference(transposed_times(A.transpose(), B), AB), tolerance);
  EXPECT_LT(difference(times(A, v), summed(A, v)), tolerance);
  EXPECT_LT(difference(minus_times(A, v), -summed(A, v)), tolerance);
  EXPECT_LT(difference(transposed_times_vector(A.transpose(), v), summed(A, v)), tolerance);
  EXPECT_LT(difference(row_times(v.transpose(), B), summed(v.transpose(), B)), tolerance);
  const Eigen::MatrixXcd Z = std::complex<double>(0.0, 2.0) * A;
  EXPECT_LT(difference(complex_block_product(Z, B).imag(), 2.0 * AB), 2.0 * tolerance);
}

TEST_P(BlockProducts, AreWrittenToTheirPlaceAlone) {
  const auto [m, k, n] = GetParam();
  const double tolerance = 1e-15 * static_cast<double>(std::max<Eigen::Index>(k, 1));
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(m, k), B = Eigen::MatrixXd::Random(k, n);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Ones(m + 2, n + 1);
  expected.block(1, 1, m, n) = summed(A, B);
  Eigen::MatrixXd C = Eigen::MatrixXd::Ones(m + 2, n + 1), D = C;
  set_product(C.block(1, 1, m, n), A, B);
  set_times_transposed(D.block(1, 1, m, n), A, B.transpose());
  EXPECT_LT(difference(C, expected), tolerance);
  EXPECT_LT(difference(D, expected), tolerance);
}

using Sizes = std::array<Eigen::Index, 3>;
INSTANTIATE_TEST_SUITE_P(SmallAndLarge, BlockProducts,
                         testing::Values(Sizes{2, 3, 4}, Sizes{1, 9, 5}, Sizes{9, 5, 1}, Sizes{40, 33, 27},
                                         Sizes{3, 0, 2}, Sizes{0, 3, 2}));

TEST(ColumnsOfAMatrix, AreChosenInTheirOrder) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(5, 4);
  const std::vector<int> J{3, 1};
  const Eigen::MatrixXd chosen = chosen_columns(A, J);
  EXPECT_EQ(chosen.col(0), A.col(3));
  EXPECT_EQ(chosen.col(1), A.col(1));
  EXPECT_LT(difference(columns_times(A, J, Eigen::Vector2d(2.0, -1.0)), 2.0 * A.col(3) - A.col(1)), 1e-15);
  const Eigen::VectorXd v = Eigen::VectorXd::Random(5);
  EXPECT_LT(difference(transposed_columns_times(A, J, v), Eigen::Vector2d(A.col(3).dot(v), A.col(1).dot(v))),
            1e-14);
  EXPECT_EQ(chosen_columns(A, {}).cols(), 0);
}

}  // namespace
}  // namespace signorini::block_products_test
