#include "problems/linear_algebra/cholesky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::cholesky_test {
namespace {

using namespace test;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// `A` with what nobody may look at above its diagonal.
Matrix lower_part(Matrix A) {
  for (int j = 0; j < static_cast<int>(A.cols()); ++j) {
    for (int i = 0; i < j; ++i) A(i, j) = kNone;
  }
  return A;
}

TEST(CholeskyFactors, SolveWithTheLowerTriangle) {
  for (const int size : kSizes) {
    const Matrix A = least_index_matrix(size), inverse = least_index_inverse(size),
                 B = random_matrix(size, 3, 1);
    const CholeskyFactors factors(lower_part(A));
    ASSERT_TRUE(factors.definite()) << size;
    EXPECT_LT(distance(factors.inverse(), inverse), 1e-12) << size;
    EXPECT_LT(distance(factors.solve(B), product(inverse, B)), 1e-12) << size;
    const Vector b = random_vector(size, 2);
    EXPECT_LT(distance(factors.solve(b), product(inverse, b)), 1e-12) << size;
  }
}

TEST(CholeskyFactors, SolveToTheRoundingOfTheMatrix) {
  for (const int size : kSizes) {
    const Matrix C = random_matrix(size, size + 2, 1), A = product(C, transposed(C));
    const Vector b = random_vector(size, 2), x = CholeskyFactors(A).solve(b);
    EXPECT_LT(distance(product(A, x), b), 4.0 * kEps * column_norm(A) * largest(x)) << size;
  }
}

// The shifted chain has k + 1 negative eigenvalues for a shift between numbers k and k + 1.
TEST(CholeskyFactors, AreDefiniteWhereAllEigenvaluesArePositive) {
  for (const int size : {2, 31, 33, 80}) {
    const double least = chain_eigenvalue(size, 0);
    for (const double shift : {least - 1e-6, least + 1e-6, 0.5 * (least + chain_eigenvalue(size, 1)), 5.0}) {
      Matrix A = spring_chain(size);
      for (int i = 0; i < size; ++i) A(i, i) -= shift;
      EXPECT_EQ(CholeskyFactors(A).definite(), shift < least) << size << ' ' << shift;
    }
  }
  EXPECT_FALSE(CholeskyFactors(Matrix::Zero(1, 1)).definite());
}

TEST(CholeskyFactors, OfWhatIsNotANumberAreNotDefinite) {
  for (const int size : {1, 2, 33, 80}) {
    for (const int column : {0, size - 1}) {
      Matrix A = least_index_matrix(size);
      A(size - 1, column) = kNone;
      EXPECT_FALSE(CholeskyFactors(A).definite()) << size << ' ' << column;
    }
  }
}

TEST(CholeskyFactors, EstimateTheCondition) {
  for (const int size : {31, 32, 33, 80}) {
    const double exact = 1.0 / (0.5 * size * (size + 1) * 4.0),
                 estimate = CholeskyFactors(least_index_matrix(size)).reciprocal_condition();
    EXPECT_GE(estimate, exact * (1.0 - 1e-10)) << size;  // |A^-1| is estimated from below
    EXPECT_LE(estimate, 3.0 * exact) << size;
  }
}

// L^T of ones sums the rows from each on; L B would sum those up to it.
TEST(CholeskyFactors, MultiplyByTheUpperFactor) {
  for (const int size : kSizes) {
    const Matrix B = random_matrix(size, 2, 1),
                 result = CholeskyFactors(least_index_matrix(size)).upper_times(B),
                 expected = product(transposed(lower_ones(size)), B);
    EXPECT_LT(distance(result, expected), 1e-12) << size;
  }
}

TEST(CholeskyFactors, NormaliseColumns) {
  for (const int size : kSizes) {
    const Matrix Q = orthogonal_matrix(size + 3, 1);
    Matrix B(size + 3, size);  // columns of Q summed up: Q L^T, whose Gram matrix is L L^T
    for (int i = 0; i < size + 3; ++i) {
      double sum = 0.0;
      for (int j = 0; j < size; ++j) B(i, j) = sum += Q(i, j);
    }
    Matrix normalised = B;
    CholeskyFactors(product(transposed(B), B)).normalise_columns(normalised);
    EXPECT_LT(distance_from_orthonormal(normalised), 1e-12 * size) << size;
    double worst = 0.0;  // it is Q again: signs and order are kept
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size + 3; ++i) worst = std::max(worst, std::abs(normalised(i, j) - Q(i, j)));
    }
    EXPECT_LT(worst, 1e-12 * size) << size;
  }
}

TEST(CholeskyFactors, OfNothing) {
  const CholeskyFactors factors(Matrix(0, 0));
  EXPECT_TRUE(factors.definite());
  EXPECT_EQ(factors.solve(Vector(0)).size(), 0);
  EXPECT_EQ(factors.inverse().size(), 0);
}

TEST(LdltSolve, SolvesDefiniteEquations) {
  for (const int size : kSizes) {
    const Vector b = random_vector(size, 1), x = ldlt_solve(lower_part(spring_chain(size)), b);
    double worst = 0.0;
    for (int i = 0; i < size; ++i) {
      double expected = 0.0;
      for (int j = 0; j < size; ++j) expected += chain_flexibility(size, i, j) * b[j];
      worst = std::max(worst, std::abs(x[i] - expected));
    }
    EXPECT_LT(worst, kEps * size * size * size) << size;
  }
}

// A chain that is free at both ends can be moved as a whole; loads in balance have a solution.
TEST(LdltSolve, SolvesSemiDefiniteEquationsInBalance) {
  for (const int size : {2, 31, 33, 80}) {
    Matrix A = spring_chain(size);
    A(0, 0) = A(size - 1, size - 1) = 1.0;
    Vector b = Vector::Zero(size);
    b[0] = 3.0;
    b[size - 1] = -3.0;
    const Vector x = ldlt_solve(A, b);
    EXPECT_LT(distance(product(A, x), b), 1e-10) << size;
    for (int i = 1; i < size; ++i) EXPECT_NEAR(x[i] - x[i - 1], -3.0, 1e-10) << size;
  }
}

TEST(LdltSolve, SolvesIndefiniteEquationsWithADiagonal) {
  Matrix A(2, 2);
  A << 1.0, 2.0, 2.0, -3.0;
  Vector b(2);
  b << 5.0, -4.0;
  const Vector x = ldlt_solve(A, b);
  EXPECT_NEAR(x[0], 1.0, 1e-15);
  EXPECT_NEAR(x[1], 2.0, 1e-15);
}

TEST(LdltSolve, HandsOnWhatIsNotANumber) {
  Matrix A = least_index_matrix(33);
  A(32, 0) = kNone;
  EXPECT_TRUE(any_nan(ldlt_solve(A, random_vector(33, 1))));
}

}  // namespace
}  // namespace signorini::cholesky_test
