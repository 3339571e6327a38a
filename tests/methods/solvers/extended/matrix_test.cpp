#include "methods/solvers/extended/matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini::matrix_test {
namespace {

using Eigen::Index;

constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

// Small integers, of which sums and products are exact.
ExtendedMatrix integers(Index rows, Index columns, int seed) {
  ExtendedMatrix A(rows, columns);
  for (Index i = 0; i < A.size(); ++i)
    A.data()[i] = static_cast<long double>((7 * i * i + 5 * i + seed) % 11 - 5);
  return A;
}

// Unit lower triangular, but for a diagonal of 1, 2, 3, ...
ExtendedMatrix integer_factor(Index n) {
  ExtendedMatrix L = integers(n, n, 3);
  for (Index j = 0; j < n; ++j) {
    L(j, j) = static_cast<long double>(j + 1);
    for (Index i = 0; i < j; ++i) L(i, j) = 0.0L;
  }
  return L;
}

// sum_k A_ik B_kj.
long double entry_of_product(const ExtendedMatrix& A, const ExtendedMatrix& B, Index i, Index j) {
  long double sum = 0.0L;
  for (Index k = 0; k < A.cols(); ++k) sum += A(i, k) * B(k, j);
  return sum;
}

void expect_equal(const ExtendedMatrix& A, const ExtendedMatrix& B) {
  ASSERT_EQ(A.rows(), B.rows());
  ASSERT_EQ(A.cols(), B.cols());
  EXPECT_TRUE(std::equal(A.data(), A.data() + A.size(), B.data())) << A.rows() << " x " << A.cols();
}

TEST(ExtendedMatrix, HoldsWhatADoubleHoldsAndIsRoundedToTheNearest) {
  Eigen::MatrixXd A(2, 3);
  for (int i = 0; i < 6; ++i) A.data()[i] = 0.1 * (i + 1);
  EXPECT_EQ(extended::rounded(extended::widened(A)), A);
  EXPECT_EQ(extended::widened(A)(1, 2), static_cast<long double>(A(1, 2)));
  ExtendedMatrix one(1, 1);
  one(0, 0) = 1.0L + 0x1p-60L;
  EXPECT_EQ(extended::rounded(one)(0, 0), 1.0);
  one(0, 0) = 1.0L + 0x1.8p-53L;
  EXPECT_EQ(extended::rounded(one)(0, 0), 1.0 + 0x1p-52);
  EXPECT_EQ(extended::rounded(ExtendedMatrix(0, 0)).size(), 0);
}

TEST(ExtendedMatrix, KnowsWhatIsFinite) {
  ExtendedMatrix A = extended::identity(3);
  EXPECT_TRUE(extended::all_finite(A));
  A(1, 2) = std::numeric_limits<long double>::infinity();
  EXPECT_FALSE(extended::all_finite(A));
  A(1, 2) = std::numeric_limits<long double>::quiet_NaN();
  EXPECT_FALSE(extended::all_finite(A));
}

TEST(ExtendedMatrix, NormIsTheRootOfTheSumOfSquares) {
  ExtendedMatrix A(1, 2);
  A(0, 0) = 3e300L;
  A(0, 1) = -4e300L;
  EXPECT_NEAR(static_cast<double>(extended::norm(A) / 5e300L), 1.0, 1e-18);
  EXPECT_EQ(extended::norm(ExtendedMatrix(0, 0)), 0.0L);
}

TEST(ExtendedMatrix, ProductsAreSumsOfProducts) {
  for (const auto& [rows, depth, columns] : {std::tuple<Index, Index, Index>{1, 1, 1},
                                             {2, 3, 4},
                                             {5, 1, 3},
                                             {4, 7, 5},
                                             {1, 6, 2},
                                             {3, 0, 2},
                                             {0, 2, 3}}) {
    const ExtendedMatrix A = integers(rows, depth, 1), B = integers(depth, columns, 2);
    ExtendedMatrix expected(rows, columns), turned(depth, rows);
    for (Index i = 0; i < rows; ++i) {
      for (Index j = 0; j < columns; ++j) expected(i, j) = entry_of_product(A, B, i, j);
      for (Index k = 0; k < depth; ++k) turned(k, i) = A(i, k);
    }
    expect_equal(extended::product(A, B), expected);
    expect_equal(extended::transposed(A), turned);
    expect_equal(extended::transposed_product(turned, B), expected);
    expect_equal(extended::product(extended::identity(rows), A), A);
  }
}

TEST(ExtendedCholesky, FindsTheFactorOfIntegers) {
  for (Index n = 0; n < 8; ++n) {
    const ExtendedMatrix L = integer_factor(n);
    ExtendedMatrix A(n, n);
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < n; ++i) {
        A(i, j) = i < j ? 1e9L : 0.0L;  // not read
        for (Index k = 0; k < n && i >= j; ++k) A(i, j) += L(i, k) * L(j, k);
      }
    }
    const extended::Cholesky found = extended::cholesky(A);
    EXPECT_TRUE(found.definite);
    expect_equal(found.L, L);
  }
}

TEST(ExtendedCholesky, SaysWhereAMatrixIsNotDefinite) {
  ExtendedMatrix A = extended::identity(3);
  A(1, 0) = 1.0L;  // of rank two
  EXPECT_FALSE(extended::cholesky(A).definite);
  A(1, 0) = 0.0L;
  A(2, 2) = -4.0L;
  const extended::Cholesky found = extended::cholesky(A);
  EXPECT_FALSE(found.definite);
  expect_equal(found.L, A);
  A(2, 2) = std::numeric_limits<long double>::quiet_NaN();
  EXPECT_FALSE(extended::cholesky(A).definite);
}

TEST(ExtendedSolveLower, UndoesTheProduct) {
  for (const auto& [n, columns] : {std::pair<Index, Index>{1, 1}, {4, 3}, {7, 4}, {3, 0}}) {
    ExtendedMatrix L = integer_factor(n), X = integers(n, columns, 5), B(n, columns);
    for (Index j = 0; j < columns; ++j) {
      std::fill_n(X.data() + j * n, j % n, 0.0L);
      for (Index i = 0; i < n; ++i) B(i, j) = entry_of_product(L, X, i, j);
    }
    for (Index j = 0; j < n; ++j) std::fill_n(L.data() + j * n, j, 1e9L);  // not read
    expect_equal(extended::solve_lower(L, B), X);
  }
}

TEST(ExtendedInverse, OfTheHilbertMatrixHasItsIntegers) {
  // (H^-1)_ij = (-1)^(i+j) (i+j-1) C(n+i-1, n-j) C(n+j-1, n-i) C(i+j-2, i-1)^2, i and j from 1 on. The
  // condition number of H is 1.5e10.
  constexpr int n = 8;
  const auto choose = [](int from, int of) {
    long double count = 1.0L;
    for (int k = 1; k <= of; ++k) count = count * (from - of + k) / k;
    return count;
  };
  ExtendedMatrix H(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) H(i, j) = 1.0L / (i + j + 1);
  }
  const auto found = extended::inverse(H);
  ASSERT_TRUE(found);
  for (int i = 1; i <= n; ++i) {
    for (int j = 1; j <= n; ++j) {
      const long double expected = ((i + j) % 2 == 0 ? 1.0L : -1.0L) * (i + j - 1) *
                                   choose(n + i - 1, n - j) * choose(n + j - 1, n - i) *
                                   std::pow(choose(i + j - 2, i - 1), 2.0L);
      EXPECT_LT(std::abs((*found)(i - 1, j - 1) / expected - 1.0L), 1.5e10L * kRounding) << i << ", " << j;
    }
  }
}

TEST(ExtendedInverse, PivotsAndRefusesSingularMatrices) {
  constexpr Index n = 5;
  ExtendedMatrix P(n, n);
  std::fill_n(P.data(), n * n, 0.0L);
  for (Index i = 0; i < n; ++i) P((2 * i + 1) % n, i) = 2.0L;
  ExtendedMatrix expected(n, n);
  for (Index i = 0; i < n * n; ++i) expected(i / n, i % n) = 0.25L * P(i % n, i / n);
  expect_equal(extended::inverse(P).value(), expected);
  EXPECT_EQ(extended::inverse(ExtendedMatrix(0, 0)).value().size(), 0);
  ExtendedMatrix singular = P;
  singular(3, 1) = 0.0L;
  EXPECT_FALSE(extended::inverse(singular));
  for (Index i = 0; i < n * n; ++i) {
    ExtendedMatrix unknown = P;
    unknown.data()[i] = std::numeric_limits<long double>::quiet_NaN();
    EXPECT_FALSE(extended::inverse(unknown)) << i;
  }
}

}  // namespace
}  // namespace signorini::matrix_test
