#include "problems/linear_algebra/sparse/sparse_factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::sparse_factors_test {
namespace {

using namespace test;

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The lower triangle of 2 - shift on the diagonal and -1 beside it; `above` stands above the diagonal.
Sparse chain(int size, double shift = 0.0, double above = -1.0) {
  Sparse A(size, size);
  for (int i = 0; i < size; ++i) {
    A.insert(i, i) = 2.0 - shift;
    if (i == 0) continue;
    A.insert(i, i - 1) = -1.0;
    A.insert(i - 1, i) = above;
  }
  return A;
}

Sparse diagonal(std::initializer_list<double> entries) {
  Sparse A(static_cast<int>(entries.size()), static_cast<int>(entries.size()));
  int i = 0;
  for (const double entry : entries) {
    A.insert(i, i) = entry;
    ++i;
  }
  return A;
}

Matrix flexibility(int size) {
  Matrix result(size, size);
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) result(i, j) = chain_flexibility(size, i, j);
  }
  return result;
}

Matrix dense(const Sparse& A) {
  Matrix result = Matrix::Zero(A.rows(), A.cols());
  for (int j = 0; j < static_cast<int>(A.outerSize()); ++j) {
    for (Sparse::InnerIterator entry(A, j); entry; ++entry) result(entry.row(), j) = entry.value();
  }
  return result;
}

TEST(SparseLlt, SolveASpringChainByItsLowerTriangle) {
  for (const int size : kSizes) {
    const SparseLlt factors(chain(size, 0.0, 17.0));
    ASSERT_TRUE(factors.definite()) << size;
    const Matrix B = random_matrix(size, 3, 1), inverse = flexibility(size);
    const double bound = kEps * size * size * size;
    EXPECT_LT(distance(factors.solve(B), product(inverse, B)), bound) << size;
    const Vector b = random_vector(size, 2);
    EXPECT_LT(distance(factors.solve(b), product(inverse, b)), bound) << size;
  }
}

// An arrow fills up in its own order, and not in one of minimum degree, by which its tip goes last.
TEST(SparseLlt, SolveInAnOrderOfTheirOwn) {
  constexpr int kSize = 33;
  Sparse A(kSize, kSize);
  A.insert(0, 0) = 2.0 * kSize;
  for (int i = 1; i < kSize; ++i) {
    A.insert(i, i) = 1.0 + i;
    A.insert(i, 0) = 1.0;
  }
  Vector expected(kSize), b(kSize);
  for (int i = 0; i < kSize; ++i) expected[i] = i - 3.0;
  b[0] = 2.0 * kSize * expected[0];
  for (int i = 1; i < kSize; ++i) {
    b[0] += expected[i];
    b[i] = expected[0] + (1.0 + i) * expected[i];
  }
  EXPECT_LT(distance(SparseLlt(A).solve(b), expected), 1e-12);
  EXPECT_LT(distance(SparseLdlt(A).solve(Matrix(b)), Matrix(expected)), 1e-12);
}

TEST(SparseLlt, AreDefiniteWhereAllEigenvaluesArePositive) {
  for (const int size : {2, 31, 33, 80}) {
    const double least = chain_eigenvalue(size, 0);
    EXPECT_TRUE(SparseLlt(chain(size, least - 1e-6)).definite()) << size;
    EXPECT_FALSE(SparseLlt(chain(size, least + 1e-6)).definite()) << size;
    EXPECT_FALSE(SparseLlt(chain(size, 5.0)).definite()) << size;
  }
  EXPECT_FALSE(SparseLlt(Sparse(2, 2)).definite());  // without a single entry
}

TEST(SparseLlt, OutliveTheOneThatTheyAreCopiedFrom) {
  auto first = std::make_unique<SparseLlt>(chain(33));
  const SparseLlt copy = *first;
  first.reset();
  const Vector b = random_vector(33, 1);
  EXPECT_LT(distance(copy.solve(b), product(flexibility(33), b)), 1e-11);
}

TEST(SparseFactors, OfWhatIsNotANumberAreNoFactors) {
  for (const int size : {1, 2, 33}) {
    for (const int column : {0, size - 1}) {
      Sparse A = chain(size);
      A.coeffRef(size - 1, column) = kNone;
      EXPECT_FALSE(SparseLlt(A).definite()) << size << ' ' << column;
      EXPECT_FALSE(SparseLdlt(A).regular()) << size << ' ' << column;
    }
  }
}

TEST(SparseLdlt, SolveIndefiniteEquations) {
  for (const int size : kSizes) {  // the shifted chain is inverted in its modes
    const double shift = size == 1 ? 3.0 : 0.3 * chain_eigenvalue(size, 0) + 0.7 * chain_eigenvalue(size, 1);
    const SparseLdlt factors(chain(size, shift, 17.0));
    ASSERT_TRUE(factors.regular()) << size;
    EXPECT_LT(factors.least_pivot(), 0.0) << size;
    const Matrix B = random_matrix(size, 2, 1);
    Matrix expected = Matrix::Zero(size, 2);
    for (int k = 0; k < size; ++k) {
      for (int j = 0; j < 2; ++j) {
        double share = 0.0;
        for (int i = 0; i < size; ++i) share += chain_mode(size, i, k) * B(i, j);
        for (int i = 0; i < size; ++i) {
          expected(i, j) += chain_mode(size, i, k) * share / (chain_eigenvalue(size, k) - shift);
        }
      }
    }
    const double bound = 1e-12 * std::max(1, size * size);
    EXPECT_LT(distance(factors.solve(B), expected), bound) << size;
    Sparse load(size, 2);
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < size; ++i) load.insert(i, j) = B(i, j);
    }
    EXPECT_LT(distance(dense(factors.solve(load)), expected), bound) << size;
  }
}

TEST(SparseLdlt, HaveTheirLeastPivotOfEitherSign) {
  EXPECT_EQ(SparseLdlt(diagonal({3.0, 0.5, 2.0})).least_pivot(), 0.5);
  EXPECT_EQ(SparseLdlt(diagonal({3.0, -5.0, 2.0})).least_pivot(), -5.0);
  EXPECT_NEAR(SparseLdlt(chain(2)).least_pivot(), 1.5, 1e-15);
}

TEST(SparseLdlt, AreRegularUntilAPivotIsZero) {
  Sparse free(2, 2);  // two masses joined by one spring
  free.insert(0, 0) = free.insert(1, 1) = 1.0;
  free.insert(1, 0) = free.insert(0, 1) = -1.0;
  EXPECT_FALSE(SparseLdlt(free).regular());
  EXPECT_FALSE(SparseLdlt(diagonal({1.0, 0.0})).regular());
  EXPECT_TRUE(SparseLdlt(diagonal({1.0, -1e-300})).regular());
}

TEST(SparseFactors, OfNothing) {
  EXPECT_TRUE(SparseLlt(Sparse(0, 0)).definite());
  EXPECT_EQ(SparseLlt(Sparse(0, 0)).solve(Vector(0)).size(), 0);
  EXPECT_TRUE(SparseLdlt(Sparse(0, 0)).regular());
  EXPECT_EQ(SparseLdlt(Sparse(0, 0)).solve(Matrix(0, 2)).cols(), 2);
}

}  // namespace
}  // namespace signorini::sparse_factors_test
