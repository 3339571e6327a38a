#include "problems/linear_algebra/complex_lu.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::complex_lu_test {
namespace {

using namespace test;

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;
using ComplexVector = Eigen::VectorXcd;

ComplexMatrix random_complex(int rows, int columns, unsigned seed) {
  const Matrix real = random_matrix(rows, columns, seed), imaginary = random_matrix(rows, columns, seed + 50);
  ComplexMatrix A(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) A(i, j) = {real(i, j), imaginary(i, j)};
  }
  return A;
}

/// exp(sign 2 pi i j k / n), of the discrete Fourier transform: n times the inverse of that of the other
/// sign.
ComplexMatrix fourier_matrix(int size, double sign) {
  ComplexMatrix F(size, size);
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      F(j, k) = std::polar(1.0, sign * 2.0 * std::numbers::pi * ((j * k) % size) / size);
    }
  }
  return F;
}

ComplexVector column(const ComplexMatrix& B, int k) {
  ComplexVector b(B.rows());
  for (int i = 0; i < static_cast<int>(B.rows()); ++i) b[i] = B(i, k);
  return b;
}

void expect_solved(const ComplexMatrix& A, const ComplexMatrix& X, const ComplexMatrix& B) {
  const auto size = static_cast<double>(A.rows());
  const double scale = size * 4.0 * complex_distance(X, ComplexMatrix::Zero(X.rows(), X.cols()));
  EXPECT_LT(complex_distance(complex_product(A, X), B), 4.0 * kEps * scale) << size;
}

TEST(ComplexLuFactors, SolveToTheRoundingOfTheMatrix) {
  for (const int size : kSizes) {
    const ComplexMatrix A = random_complex(size, size, 1), B = random_complex(size, 3, 2);
    const ComplexVector b = column(B, 2);
    const ComplexLuFactors lu(A);
    expect_solved(A, lu.solve(B), B);
    expect_solved(A, lu.solve(b), b);
    expect_solved(A, lu_solve(A, b), b);
    expect_solved(A, CompleteComplexLuFactors(A).solve(B), B);
  }
}

// The conjugate or the transpose of an answer would pass neither.
TEST(ComplexLuFactors, KeepSignsAndRowsApart) {
  ComplexMatrix A(2, 2);
  A << Complex(0.0, 0.0), Complex(0.0, 1.0), Complex(2.0, 0.0), Complex(0.0, 0.0);
  ComplexVector b(2);
  b << Complex(1.0, 0.0), Complex(0.0, 2.0);
  const ComplexVector x = lu_solve(A, b);
  EXPECT_EQ(x[0], Complex(0.0, 1.0));
  EXPECT_EQ(x[1], Complex(0.0, -1.0));
  const ComplexMatrix inverted = inverse(A);
  EXPECT_EQ(inverted(1, 0), Complex(0.0, -1.0));
  EXPECT_EQ(inverted(0, 1), Complex(0.5, 0.0));
}

TEST(ComplexLuFactors, InvertTheFourierTransform) {
  for (const int size : kSizes) {
    const ComplexMatrix F = fourier_matrix(size, -1.0);
    ComplexMatrix expected = fourier_matrix(size, 1.0);
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) expected(i, j) /= size;
    }
    EXPECT_LT(complex_distance(ComplexLuFactors(F).inverse(), expected), 20.0 * kEps) << size;
    EXPECT_LT(complex_distance(inverse(F), expected), 20.0 * kEps) << size;
    EXPECT_LT(complex_distance(CompleteComplexLuFactors(F).inverse(), expected), 20.0 * kEps) << size;
  }
}

// One row of 10 i beside a diagonal of one: |A|_1 |A^-1|_1 = 121, |A|_inf |A^-1|_inf = (10 n - 9)^2.
TEST(ComplexLuFactors, EstimateTheConditionInTheNormOfColumns) {
  for (const int size : {31, 32, 33, 80}) {
    ComplexMatrix A(size, size);
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) A(i, j) = i == j ? Complex(1.0) : i == 0 ? Complex(0.0, 10.0) : 0.0;
    }
    for (const double estimate :
         {ComplexLuFactors(A).reciprocal_condition(), CompleteComplexLuFactors(A).reciprocal_condition()}) {
      EXPECT_GE(estimate, (1.0 - 1e-10) / 121.0) << size;
      EXPECT_LE(estimate, 3.0 / 121.0) << size;
    }
  }
}

TEST(ComplexLuFactors, OfASingularMatrixSolveToNoFiniteNumber) {
  ComplexMatrix A(2, 2);
  A << Complex(1.0), Complex(0.0, 1.0), Complex(0.0, 1.0), Complex(-1.0);
  ComplexVector b(2);
  b << Complex(1.0), Complex(1.0);
  EXPECT_FALSE(std::isfinite(std::abs(lu_solve(A, b)[1])));
  EXPECT_FALSE(std::isfinite(std::abs(inverse(A)(1, 1))));
}

TEST(Invert, OfFewRowsGivesTheInverseAndItsCondition) {
  for (int size = 1; size <= kMostInverted; ++size) {
    ComplexMatrix F = fourier_matrix(size, -1.0);
    const ComplexMatrix before = F;
    ASSERT_TRUE(invert(F)) << size;
    EXPECT_LT(complex_distance(static_cast<double>(size) * F, fourier_matrix(size, 1.0)), 20.0 * kEps * size)
        << size;
    // |F|_1 = n and |F^-1|_1 = 1: moduli taken as |re| + |im| are at most twice as large together.
    const double condition = reciprocal_condition(before, F);
    EXPECT_GE(condition, (1.0 - 1e-10) / size) << size;
    EXPECT_LE(condition, (2.0 + 1e-10) / size) << size;
    const ComplexMatrix A = random_complex(size, size, 3);
    ComplexMatrix inverted = A;
    ASSERT_TRUE(invert(inverted)) << size;
    expect_solved(A, inverted, ComplexMatrix::Identity(size, size));
  }
}

// No pivot on the diagonal: rows are exchanged, and columns of the inverse back.
TEST(Invert, ExchangesRows) {
  ComplexMatrix A(3, 3);
  A << Complex(0.0), Complex(0.0, 1.0), Complex(0.0), Complex(0.0), Complex(0.0), Complex(4.0), Complex(2.0),
      Complex(0.0), Complex(0.0);
  ASSERT_TRUE(invert(A));
  EXPECT_EQ(A(0, 2), Complex(0.5));
  EXPECT_EQ(A(1, 0), Complex(0.0, -1.0));
  EXPECT_EQ(A(2, 1), Complex(0.25));
}

TEST(Invert, RefusesWhatIsSingularOrNotANumber) {
  ComplexMatrix zero = ComplexMatrix::Zero(2, 2), singular(2, 2);
  EXPECT_FALSE(invert(zero));
  singular << Complex(1.0), Complex(0.0, 1.0), Complex(0.0, 1.0), Complex(-1.0);
  EXPECT_FALSE(invert(singular));
  ComplexMatrix unknown = ComplexMatrix::Identity(2, 2), kept = unknown;
  unknown(1, 1) = {0.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_FALSE(invert(unknown));
  EXPECT_EQ(reciprocal_condition(kept, unknown), 0.0);
}

TEST(ComplexLuFactors, HandOnWhatIsNotANumber) {
  for (const int size : {1, 2, 33}) {
    ComplexMatrix A = random_complex(size, size, 1);
    A(size - 1, 0) = {0.0, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_TRUE(any_complex_nan(inverse(A))) << size;
    EXPECT_TRUE(any_complex_nan(lu_solve(A, column(A, size - 1)))) << size;
  }
}

TEST(ComplexLuFactors, TakeAnotherMatrixOfAnotherSize) {
  ComplexLuFactors lu(random_complex(33, 33, 1));
  for (const int size : {0, 2, 40}) {
    const ComplexMatrix A = random_complex(size, size, 5), B = random_complex(size, 2, 6);
    lu.compute(A);
    const ComplexMatrix X = lu.solve(B);
    ASSERT_EQ(X.rows(), size);
    if (size > 0) expect_solved(A, X, B);
  }
}

// Of columns a_1, a_2, a_1 + i a_2, and equations that have a solution.
TEST(CompleteComplexLuFactors, SolveTheSingularEquationsThatHaveASolution) {
  ComplexMatrix A = random_complex(3, 3, 1);
  for (int i = 0; i < 3; ++i) A(i, 2) = A(i, 0) + Complex(0.0, 1.0) * A(i, 1);
  const ComplexMatrix B = complex_product(A, random_complex(3, 2, 2));
  const ComplexMatrix X = CompleteComplexLuFactors(A).solve(B);
  EXPECT_LT(complex_distance(complex_product(A, X), B), 1e-14);
}

}  // namespace
}  // namespace signorini::complex_lu_test
