#include "problems/linear_algebra/products.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace signorini::products_test {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

Eigen::MatrixXd random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::MatrixXd result(rows, columns);
  for (double& value : result.reshaped()) value = number(random);
  return result;
}

Eigen::MatrixXcd random_complex(Index rows, Index columns, unsigned seed) {
  Eigen::MatrixXcd result(rows, columns);
  result.real() = random_matrix(rows, columns, seed);
  result.imag() = random_matrix(rows, columns, seed + 1);
  return result;
}

// sum_k a(i, k) b(k, j), term by term.
template <class A, class B>
Eigen::MatrixXcd summed(Index rows, Index inner, Index columns, const A& a, const B& b) {
  Eigen::MatrixXcd result(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i) {
      Complex sum = 0.0;
      for (Index k = 0; k < inner; ++k) sum += Complex(a(i, k)) * Complex(b(k, j));
      result(i, j) = sum;
    }
  }
  return result;
}

// The largest difference of entries; infinite for other shapes.
double distance(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return std::numeric_limits<double>::infinity();
  return a.size() == 0 ? 0.0 : (a - b).cwiseAbs().maxCoeff();
}

Eigen::MatrixXcd wide(const Eigen::MatrixXd& A) { return A.cast<Complex>(); }

constexpr double kRounding = 1e-13;  // of sums of 40 terms up to 2

// Sizes for which Eigen takes other loops: vectors, products of coefficients, kernels.
class ProductsOfSize : public testing::TestWithParam<std::vector<Index>> {
 protected:
  const Index m = GetParam()[0], k = GetParam()[1], n = GetParam()[2];
  const Eigen::MatrixXd A = random_matrix(m, k, 1), B = random_matrix(k, n, 2), C = random_matrix(m, n, 3);
  const Eigen::MatrixXcd P = random_complex(m, k, 4), Q = random_complex(k, n, 6),
                         R = random_complex(m, n, 8);
  const Complex factor{0.3, -0.8};
};

TEST_P(ProductsOfSize, OfMatricesAreSumsTermByTerm) {
  const Eigen::MatrixXcd AB = summed(m, k, n, A, B), AQ = summed(m, k, n, A, Q), PQ = summed(m, k, n, P, Q);
  const Eigen::MatrixXd At = A.transpose(), Bt = B.transpose();
  Eigen::MatrixXd sum = C;
  add_product(A, B, sum);
  Eigen::MatrixXd rest = C;
  subtract_product_of_transposed(At, B, rest);
  EXPECT_LE(distance(wide(rest), wide(C) - AB), kRounding);
  EXPECT_LE(distance(wide(product(A, B)), AB), kRounding);
  EXPECT_LE(distance(wide(sum), wide(C) + AB), kRounding);
  EXPECT_LE(distance(wide(product_of_transposed(At, B)), AB), kRounding);
  EXPECT_LE(distance(wide(product_by_transposed(A, Bt)), AB), kRounding);
  EXPECT_LE(distance(wide(plus_product_of_transposed(C, At, B)), wide(C) + AB), kRounding);
  EXPECT_LE(distance(wide(plus_product_by_transposed(C, A, Bt)), wide(C) + AB), kRounding);
  EXPECT_LE(distance(product_of_complex(A, Q), AQ), kRounding);
  EXPECT_LE(distance(product_in_complex(A, Q), AQ), kRounding);
  EXPECT_LE(distance(minus_product_in_complex(R, A, Q), R - AQ), kRounding);
  EXPECT_LE(distance(product_by_real(P, B), summed(m, k, n, P, B)), kRounding);
  EXPECT_LE(distance(product_by_real_transposed(P, Bt), summed(m, k, n, P, B)), kRounding);
  EXPECT_LE(distance(complex_product(factor, P, Q), factor * PQ), kRounding);
  EXPECT_LE(distance(complex_product_of_transposed(Eigen::MatrixXcd(P.transpose()), Q), PQ), kRounding);
}

TEST_P(ProductsOfSize, OfMatrixAndVectorAreSumsTermByTerm) {
  const Eigen::VectorXd v = B.col(0), c = C.col(0);
  const Eigen::VectorXcd w = Q.col(0), r = R.col(0);
  const Eigen::MatrixXcd Av = summed(m, k, 1, A, v), Aw = summed(m, k, 1, A, w);
  const Eigen::MatrixXd At = A.transpose();
  Eigen::VectorXd sum = c;
  add_image(A, v, sum);
  Eigen::VectorXcd rest = r;
  subtract_image_of_complex(A, w, rest);
  EXPECT_LE(distance(wide(image(A, v)), Av), kRounding);
  EXPECT_LE(distance(wide(negative_image(A, v)), -Av), kRounding);
  EXPECT_LE(distance(wide(image_by_transposed(At, v)), Av), kRounding);
  EXPECT_LE(distance(wide(sum), wide(c) + Av), kRounding);
  EXPECT_LE(distance(image_of_complex(A, w), Aw), kRounding);
  EXPECT_LE(distance(image_of_complex_by_transposed(At, w), Aw), kRounding);
  EXPECT_LE(distance(rest, r - Aw), kRounding);
  EXPECT_LE(distance(image_in_complex(A, w), Aw), kRounding);
  EXPECT_LE(distance(image_in_complex(factor, A, w), factor * Aw), kRounding);
  EXPECT_LE(distance(complex_image(P, w), summed(m, k, 1, P, w)), kRounding);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ProductsOfSize,
                         testing::Values(std::vector<Index>{1, 1, 1}, std::vector<Index>{1, 5, 3},
                                         std::vector<Index>{4, 3, 1}, std::vector<Index>{5, 4, 6},
                                         std::vector<Index>{23, 40, 17}, std::vector<Index>{30, 2, 1},
                                         std::vector<Index>{1, 2, 30}, std::vector<Index>{3, 0, 2}));

TEST(Products, OfSomeColumnsAreThoseOfTheirCopy) {
  const Eigen::MatrixXd A = random_matrix(7, 5, 1), v = random_matrix(3, 1, 2), u = random_matrix(7, 1, 3);
  const std::vector<int> J{0, 3, 4};
  Eigen::MatrixXd chosen(7, 3);
  chosen << A.col(0), A.col(3), A.col(4);
  EXPECT_EQ(columns_of(A, J), chosen);
  EXPECT_LE(distance(wide(image_by_columns(A, J, v)), summed(7, 3, 1, chosen, v)), kRounding);
  EXPECT_LE(distance(wide(image_by_transposed_columns(A, J, u.col(0))),
                     summed(3, 7, 1, Eigen::MatrixXd(chosen.transpose()), u)),
            kRounding);
}

TEST(Products, PartsAreTheEntriesNamed) {
  const Eigen::MatrixXd A = random_matrix(6, 4, 1);
  const Eigen::MatrixXcd P = random_complex(6, 2, 2);
  const std::vector<int> I{5, 1}, J{0, 2, 3};
  const Eigen::MatrixXd block = block_of(A, I, J);
  const Eigen::MatrixXcd rows = rows_of(P, I);
  const Eigen::VectorXd entries = entries_of(A.col(2), I);
  Eigen::MatrixXd changed = A;
  set_rows(changed, I, random_matrix(2, 4, 3));
  ASSERT_EQ(block.rows(), 2);
  ASSERT_EQ(block.cols(), 3);
  for (int i = 0; i < 2; ++i) {
    const int row = I[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) EXPECT_EQ(block(i, j), A(row, J[static_cast<std::size_t>(j)]));
    for (int j = 0; j < 2; ++j) EXPECT_EQ(rows(i, j), P(row, j));
    EXPECT_EQ(entries[i], A(row, 2));
    EXPECT_EQ(Eigen::RowVectorXd(changed.row(row)), Eigen::RowVectorXd(random_matrix(2, 4, 3).row(i)));
  }
  EXPECT_EQ(Eigen::RowVectorXd(changed.row(0)), Eigen::RowVectorXd(A.row(0)));
}

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
class PartsOfMatrices : public testing::TestWithParam<std::array<Eigen::Index, 3>> {
 protected:
  void SetUp() override { std::srand(7); }
};

TEST_P(PartsOfMatrices, EqualTheirDefinition) {
  const auto [m, k, n] = GetParam();
  const double tolerance = 1e-15 * static_cast<double>(std::max<Eigen::Index>(k, 1));
  const Eigen::MatrixXd around = Eigen::MatrixXd::Random(m + 2, k + 3), B = Eigen::MatrixXd::Random(k, n);
  const Eigen::MatrixXd A = around.block(1, 2, m, k), AB = summed(A, B), transposed = B.transpose();
  const Eigen::VectorXd v = Eigen::VectorXd::Random(k);
  EXPECT_LT(difference(product(around.block(1, 2, m, k), B), AB), tolerance);
  EXPECT_LT(difference(product_by_transposed(A, transposed), AB), tolerance);
  EXPECT_LT(difference(product_of_transposed(A.transpose(), B), AB), tolerance);
  EXPECT_LT(difference(image(A, v), summed(A, v)), tolerance);
  EXPECT_LT(difference(negative_image(A, v), -summed(A, v)), tolerance);
  EXPECT_LT(difference(image_by_transposed(A.transpose(), v), summed(A, v)), tolerance);
  EXPECT_LT(difference(row_image(v.transpose(), B), summed(v.transpose(), B)), tolerance);
  const Eigen::MatrixXcd Z = std::complex<double>(0.0, 2.0) * A;
  EXPECT_LT(difference(complex_product(Z, B).imag(), 2.0 * AB), 2.0 * tolerance);
}

TEST_P(PartsOfMatrices, AreWrittenToTheirPlaceAlone) {
  const auto [m, k, n] = GetParam();
  const double tolerance = 1e-15 * static_cast<double>(std::max<Eigen::Index>(k, 1));
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(m, k), B = Eigen::MatrixXd::Random(k, n);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Ones(m + 2, n + 1);
  expected.block(1, 1, m, n) = summed(A, B);
  Eigen::MatrixXd C = Eigen::MatrixXd::Ones(m + 2, n + 1), D = C;
  set_product(C.block(1, 1, m, n), A, B);
  set_product_by_transposed(D.block(1, 1, m, n), A, B.transpose());
  EXPECT_LT(difference(C, expected), tolerance);
  EXPECT_LT(difference(D, expected), tolerance);
}

using Sizes = std::array<Eigen::Index, 3>;
INSTANTIATE_TEST_SUITE_P(SmallAndLarge, PartsOfMatrices,
                         testing::Values(Sizes{2, 3, 4}, Sizes{1, 9, 5}, Sizes{9, 5, 1}, Sizes{40, 33, 27},
                                         Sizes{3, 0, 2}, Sizes{0, 3, 2}));

TEST(ColumnsOfAMatrix, AreChosenInTheirOrder) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(5, 4);
  const std::vector<int> J{3, 1};
  const Eigen::MatrixXd chosen = columns_of(A, J);
  EXPECT_EQ(chosen.col(0), A.col(3));
  EXPECT_EQ(chosen.col(1), A.col(1));
  EXPECT_LT(difference(image_by_columns(A, J, Eigen::Vector2d(2.0, -1.0)), 2.0 * A.col(3) - A.col(1)), 1e-15);
  const Eigen::VectorXd v = Eigen::VectorXd::Random(5);
  EXPECT_LT(
      difference(image_by_transposed_columns(A, J, v), Eigen::Vector2d(A.col(3).dot(v), A.col(1).dot(v))),
      1e-14);
  EXPECT_EQ(columns_of(A, {}).cols(), 0);
}

}  // namespace
}  // namespace signorini::products_test
