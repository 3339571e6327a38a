#include "problems/linear_algebra/lu.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::lu_test {
namespace {

using namespace test;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// 1 on the diagonal, 10 beside it in the first row: of column norm 11 and row norm 10 n - 9, as its inverse,
/// in which the row is -10.
Matrix one_full_row(int size) {
  Matrix A(size, size);
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) A(i, j) = i == j ? 1.0 : i == 0 ? 10.0 : 0.0;
  }
  return A;
}

/// Rows turned by one place: (P b)_i = b_(i+1).
Matrix cyclic_shift(int size) {
  Matrix P(size, size);
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) P(i, j) = (i + 1) % size == j ? 1.0 : 0.0;
  }
  return P;
}

/// Of rank n - 1.
Matrix singular_matrix(int size) {
  Vector values(size);
  for (int k = 0; k < size; ++k) values[k] = k + 1 < size ? 1.0 + 0.1 * k : 0.0;
  return with_singular_values(size, size, values, 7);
}

double residual(const Matrix& A, const Vector& x, const Vector& b) {
  const Matrix Ax = product(A, Matrix(x));
  return distance(Ax, b) / (column_norm(A) * largest(x));
}

TEST(LuFactors, SolveToTheRoundingOfTheMatrix) {
  for (const int size : kSizes) {
    const Matrix A = random_matrix(size, size, 1), B = random_matrix(size, 3, 2);
    const Vector b = random_vector(size, 3);
    const LuFactors lu(A);
    EXPECT_LT(residual(A, lu.solve(b), b), 4.0 * kEps) << size;
    EXPECT_LT(residual(A, lu_solve(A, b), b), 4.0 * kEps) << size;
    const Matrix X = lu.solve(B);
    EXPECT_LT(distance(product(A, X), B), 4.0 * kEps * column_norm(A) * largest(X)) << size;
    const Matrix Y = lu_solve(A, B);
    EXPECT_LT(distance(product(A, Y), B), 4.0 * kEps * column_norm(A) * largest(Y)) << size;
  }
}

// Without pivoting both fail: zeros on the diagonal, and a pivot of 1e-20 that swamps the other row.
TEST(LuFactors, ExchangeRows) {
  const Vector b = random_vector(33, 1), x = LuFactors(cyclic_shift(33)).solve(b);
  for (int i = 0; i < 33; ++i) EXPECT_EQ(x[(i + 1) % 33], b[i]);
  Matrix graded(2, 2);
  graded << 1e-20, 1.0, 1.0, 1.0;
  Vector load(2);
  load << 1.0, 2.0;
  const Vector y = lu_solve(graded, load);
  EXPECT_NEAR(y[0], 1.0, 4.0 * kEps);
  EXPECT_NEAR(y[1], 1.0, 4.0 * kEps);
}

TEST(LuFactors, InvertAMatrixOfKnownInverse) {
  for (const int size : kSizes) {
    const Matrix inverse = LuFactors(least_index_matrix(size)).inverse();
    EXPECT_LT(distance(inverse, least_index_inverse(size)), 1e-13 * size) << size;
  }
  const Matrix inverse = LuFactors(one_full_row(5)).inverse();  // not symmetric: no transpose passes
  EXPECT_EQ(inverse(0, 4), -10.0);
  EXPECT_EQ(inverse(4, 0), 0.0);
}

TEST(LuFactors, EstimateTheConditionInTheNormOfColumns) {
  for (const int size : kSizes) {
    if (size < 3) continue;
    const double symmetric = 1.0 / (0.5 * size * (size + 1) * 4.0), column = 1.0 / 121.0,
                 row = std::pow(10.0 * size - 9.0, -2);
    const Matrix least = least_index_matrix(size), full = one_full_row(size), turned = transposed(full);
    const auto expect = [&](double estimate, double exact) {  // |A^-1| is estimated from below
      EXPECT_GE(estimate, exact * (1.0 - 1e-10)) << size;
      EXPECT_LE(estimate, 3.0 * exact) << size;
    };
    expect(LuFactors(least).reciprocal_condition(), symmetric);
    expect(LuFactors(full).reciprocal_condition(), column);
    expect(LuFactors(turned).reciprocal_condition(), row);
    expect(CompleteLuFactors(least).reciprocal_condition(), symmetric);
    expect(CompleteLuFactors(full).reciprocal_condition(), column);
    expect(CompleteLuFactors(turned).reciprocal_condition(), row);
    Matrix overwritten = turned;
    expect(LuFactorsInPlace(overwritten).reciprocal_condition(), row);
  }
  EXPECT_FALSE(LuFactors(singular_matrix(33)).reciprocal_condition() > 1e-15);  // it may be NaN
}

TEST(LuFactors, OfASingularMatrixSolveToNoFiniteNumber) {
  Matrix A(2, 2);
  A << 1.0, 1.0, 1.0, 1.0;
  Vector b(2);
  b << 1.0, 2.0;
  EXPECT_FALSE(std::isfinite(lu_solve(A, b)[1]));
  EXPECT_FALSE(std::isfinite(LuFactors(A).inverse()(1, 1)));
  EXPECT_EQ(determinant(A), 0.0);
}

TEST(LuFactors, HandOnWhatIsNotANumber) {
  for (const int size : {1, 2, 33, 80}) {
    Matrix A = least_index_matrix(size);
    A(size - 1, 0) = kNone;
    const Vector b = random_vector(size, 1);
    EXPECT_TRUE(any_nan(lu_solve(A, b))) << size;
    EXPECT_TRUE(any_nan(LuFactors(A).inverse())) << size;
    EXPECT_TRUE(std::isnan(determinant(A))) << size;
  }
}

TEST(LuFactors, TakeAnotherMatrixOfAnotherSize) {
  LuFactors lu(random_matrix(33, 33, 1));
  for (const int size : {2, 40}) {
    const Matrix A = random_matrix(size, size, 5);
    const Vector b = random_vector(size, 6);
    lu.compute(A);
    EXPECT_LT(residual(A, lu.solve(b), b), 4.0 * kEps) << size;
  }
}

TEST(LuFactors, HaveThePivotsOfTheDeterminant) {
  for (const int size : kSizes) {
    const LuFactors lu(cyclic_shift(size));  // a cycle of even length is odd
    EXPECT_EQ(lu.permutation_sign(), size % 2 == 0 ? -1.0 : 1.0) << size;
    EXPECT_EQ(lu.determinant(), lu.permutation_sign()) << size;
    const LuFactors chain(spring_chain(size));  // det = n + 1, and no row is exchanged
    EXPECT_EQ(chain.permutation_sign(), 1.0);
    for (int i = 0; i < size; ++i) EXPECT_NEAR(chain.pivots()[i], (i + 2.0) / (i + 1.0), 1e-14) << size;
    EXPECT_NEAR(determinant(spring_chain(size)) / (size + 1), 1.0, 1e-13) << size;
  }
}

TEST(LuFactors, OfNothing) {
  const Matrix none(0, 0);
  EXPECT_EQ(determinant(none), 1.0);
  EXPECT_EQ(lu_solve(none, Vector(0)).size(), 0);
  EXPECT_EQ(lu_solve(none, Matrix(0, 2)).cols(), 2);
}

TEST(LuFactorsInPlace, LieInTheCallersArray) {
  for (const int size : kSizes) {
    const Matrix A = random_matrix(size, size, 1);
    const Vector b = random_vector(size, 2);
    Matrix overwritten = A;
    const LuFactorsInPlace lu(overwritten);
    EXPECT_LT(residual(A, lu.solve(b), b), 4.0 * kEps) << size;
    double pivots = 1.0;
    for (int i = 0; i < size; ++i) pivots *= std::abs(overwritten(i, i));
    EXPECT_NEAR(pivots / std::abs(determinant(A)), 1.0, 1e-12) << size;
  }
}

TEST(CompleteLuFactors, SolveToTheRoundingOfTheMatrix) {
  for (const int size : kSizes) {
    const Matrix A = random_matrix(size, size, 1);
    const Vector b = random_vector(size, 2);
    const CompleteLuFactors lu(A);
    EXPECT_TRUE(lu.regular()) << size;
    EXPECT_LT(residual(A, lu.solve(b), b), 4.0 * kEps) << size;
  }
}

TEST(CompleteLuFactors, SolveTheSingularEquationsThatHaveASolution) {
  for (const int size : {2, 31, 33, 80}) {
    const Matrix A = singular_matrix(size);
    const Vector b = product(A, random_vector(size, 3));
    const CompleteLuFactors lu(A);
    EXPECT_FALSE(lu.regular()) << size;
    EXPECT_LT(lu.least_pivot(), 1e-14 * size) << size;
    EXPECT_LT(distance(product(A, lu.solve(b)), b), 1e-13 * size) << size;
  }
}

TEST(CompleteLuFactors, AreRegularDownToRounding) {
  for (const double least : {1e-10, 1e-14, 1e-17, 0.0}) {
    Matrix A(2, 2);
    A << least, 0.0, 0.0, -1.0;
    const CompleteLuFactors lu(A);
    EXPECT_EQ(lu.regular(), least > 2.0 * kEps) << least;
    EXPECT_EQ(lu.least_pivot(), least);
  }
}

TEST(LowerSolve, LooksAtTheLowerTriangleAlone) {
  for (const int size : kSizes) {
    Matrix L = lower_ones(size);
    if (size > 1) L(0, size - 1) = kNone;
    const Matrix B = random_matrix(size, 2, 4), X = lower_solve(L, B);
    for (int j = 0; j < 2; ++j) {  // sums of ones undone: differences
      for (int i = 0; i < size; ++i) {
        EXPECT_NEAR(X(i, j), B(i, j) - (i > 0 ? B(i - 1, j) : 0.0), 1e-13) << size;
      }
    }
  }
}

}  // namespace
}  // namespace signorini::lu_test
