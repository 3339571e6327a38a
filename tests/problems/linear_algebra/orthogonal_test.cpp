#include "problems/linear_algebra/orthogonal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::orthogonal_test {
namespace {

using namespace test;

/// Square, tall and wide.
constexpr std::pair<int, int> kShapes[] = {{1, 1},   {2, 2},   {31, 31}, {32, 32}, {33, 33},
                                           {80, 80}, {80, 33}, {33, 80}, {5, 1},   {1, 5}};

/// The first `rank` singular values of 2 and less, the others 0.
Matrix of_rank(int rows, int columns, int rank) {
  Vector values(std::min(rows, columns));
  for (int k = 0; k < std::min(rows, columns); ++k) values[k] = k < rank ? 2.0 - 1.0 * k / rows : 0.0;
  return with_singular_values(rows, columns, values, 3);
}

/// Its pseudo-inverse: the same vectors on the other sides, and one over each value.
Matrix inverse_of_rank(int rows, int columns, int rank) {
  const Matrix Q = orthogonal_matrix(rows, 3), P = orthogonal_matrix(columns, 4);
  Matrix result(columns, rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      result(i, j) = 0.0;
      for (int k = 0; k < rank; ++k) result(i, j) += P(i, k) * Q(j, k) / (2.0 - 1.0 * k / rows);
    }
  }
  return result;
}

/// Sums of squares of 1, x, x^2 - what a parabola leaves of points on it: y = 3 - 2 x + x^2 / 2 plus `noise`
/// that is orthogonal to all three.
struct Parabola {
  Matrix A = Matrix(5, 3);
  Vector b = Vector(5);
  explicit Parabola(double noise) {
    const double remainder[] = {1.0, -4.0, 6.0, -4.0, 1.0};  // fourth differences
    for (int i = 0; i < 5; ++i) {
      const double x = i - 2.0;
      A(i, 0) = 1.0;
      A(i, 1) = x;
      A(i, 2) = x * x;
      b[i] = 3.0 - 2.0 * x + 0.5 * x * x + noise * remainder[i];
    }
  }
};

void expect_parabola(const Vector& x) {
  ASSERT_EQ(x.size(), 3);
  EXPECT_NEAR(x[0], 3.0, 1e-13);
  EXPECT_NEAR(x[1], -2.0, 1e-13);
  EXPECT_NEAR(x[2], 0.5, 1e-13);
}

TEST(HouseholderQr, AreOrthogonalAndTriangularFactors) {
  for (const auto& [m, n] : kShapes) {
    const Matrix A = random_matrix(m, n, 1);
    const QrFactors found = householder_qr(A);
    ASSERT_EQ(found.Q.rows(), m);
    ASSERT_EQ(found.Q.cols(), m);
    ASSERT_EQ(found.R.rows(), m);
    ASSERT_EQ(found.R.cols(), n);
    EXPECT_LT(distance_from_orthonormal(found.Q), 40.0 * kEps) << m << ' ' << n;
    EXPECT_LT(distance(product(found.Q, found.R), A), 100.0 * kEps) << m << ' ' << n;
    for (int j = 0; j < n; ++j) {
      for (int i = j + 1; i < m; ++i) EXPECT_EQ(found.R(i, j), 0.0) << m << ' ' << n;
    }
    EXPECT_LT(distance(householder_basis(A), found.Q), 40.0 * kEps) << m << ' ' << n;
  }
}

// Without pivoting the first k columns of Q span those of A, whatever their lengths.
TEST(HouseholderQr, KeepTheOrderOfColumns) {
  Matrix A(2, 2);
  A << 3e-8, 1.0, 4e-8, 0.0;
  const Matrix Q = householder_basis(A);
  EXPECT_NEAR(std::abs(Q(0, 0)), 0.6, kEps);
  EXPECT_NEAR(std::abs(Q(1, 0)), 0.8, kEps);
  EXPECT_NEAR(std::abs(PivotedQr(A).basis(1)(0, 0)), 1.0, kEps);
}

TEST(PivotedQr, CountColumnsThatAddSomething) {
  for (const auto& [m, n] : kShapes) {
    const int most = std::min(m, n);
    for (const int rank : {0, most / 2, most}) {
      const Matrix A = of_rank(m, n, rank);
      const PivotedQr qr(A);
      EXPECT_EQ(qr.rank(), rank) << m << ' ' << n;
      const Vector diagonal = qr.diagonal();
      ASSERT_EQ(diagonal.size(), most);
      for (int k = 1; k < most; ++k) {
        EXPECT_LE(std::abs(diagonal[k]), std::abs(diagonal[k - 1]) + 10.0 * kEps) << m << ' ' << n;
      }
      for (const int count : {rank, m}) {
        const Matrix basis = qr.basis(count);
        ASSERT_EQ(basis.rows(), m);
        ASSERT_EQ(basis.cols(), count);
        EXPECT_LT(distance_from_orthonormal(basis), 40.0 * kEps) << m << ' ' << n;
        const Matrix projected = product(basis, product(transposed(basis), A));  // all of A lies in it
        EXPECT_LT(distance(projected, A), 200.0 * kEps) << m << ' ' << n << ' ' << rank;
      }
    }
  }
}

TEST(PivotedQr, TakeTheLongestColumnFirst) {
  Matrix A = Matrix::Zero(3, 3);
  A(1, 0) = 1.0;
  A(0, 1) = 1e-3;
  A(2, 2) = -5.0;
  const PivotedQr qr(A);
  EXPECT_EQ(qr.rank(), 3);
  const Vector diagonal = qr.diagonal();
  EXPECT_NEAR(std::abs(diagonal[0]), 5.0, 1e-15);
  EXPECT_NEAR(std::abs(diagonal[1]), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(diagonal[2]), 1e-3, 1e-18);
  EXPECT_NEAR(std::abs(qr.basis(1)(2, 0)), 1.0, 1e-15);
}

TEST(PivotedQr, CountDownToRounding) {
  for (const double least : {1e-12, 1e-17}) {
    Matrix A = Matrix::Zero(2, 2);
    A(0, 0) = 1.0;
    A(1, 1) = least;
    EXPECT_EQ(PivotedQr(A).rank(), least > 2.0 * kEps ? 2 : 1) << least;
  }
}

TEST(LeastSquares, FindAParabolaInPointsBesideIt) {
  for (const double noise : {0.0, 0.1}) {
    const Parabola problem(noise);
    expect_parabola(full_rank_least_squares(problem.A, problem.b));
    expect_parabola(pivoted_least_squares(problem.A, problem.b));
    expect_parabola(least_norm_solve(problem.A, problem.b));
  }
}

// What is left is orthogonal to all columns.
TEST(LeastSquares, LeaveWhatIsOrthogonal) {
  for (const auto& [m, n] : {std::pair{31, 31}, {33, 33}, {80, 33}, {80, 80}, {5, 1}}) {
    const Matrix A = of_rank(m, n, n);
    const Vector b = random_vector(m, 2);
    for (const Vector& x :
         {full_rank_least_squares(A, b), pivoted_least_squares(A, b), least_norm_solve(A, b)}) {
      const Vector Ax = product(A, x);
      Vector left(m);
      for (int i = 0; i < m; ++i) left[i] = b[i] - Ax[i];
      EXPECT_LT(largest(product(transposed(A), left)), 200.0 * kEps) << m << ' ' << n;
    }
  }
}

TEST(LeastSquares, GiveNothingToColumnsBelowTheThreshold) {
  Matrix A = Matrix::Zero(3, 2);
  A(0, 0) = 1.0;
  A(1, 1) = 1e-6;
  Vector b(3);
  b << 2.0, 3.0, 7.0;
  for (const double threshold : {0.0, 1e-8, 1e-4}) {
    const Vector x = pivoted_least_squares(A, b, threshold);
    EXPECT_NEAR(x[0], 2.0, 1e-14) << threshold;
    EXPECT_NEAR(x[1], threshold > 1e-6 ? 0.0 : 3e6, 1e-8) << threshold;
  }
  const Matrix deficient = of_rank(33, 33, 16);
  const Vector load = product(deficient, random_vector(33, 1)),
               x = pivoted_least_squares(deficient, load, 1e-12);
  EXPECT_LT(distance(product(deficient, x), load), 1e-13);
  EXPECT_EQ(std::count(x.begin(), x.end(), 0.0), 17);
}

TEST(LeastNorm, IsThePseudoInverse) {
  for (const auto& [m, n] : kShapes) {
    const int most = std::min(m, n);
    for (const int rank : {0, most / 2, most}) {
      const Matrix A = of_rank(m, n, rank), expected = inverse_of_rank(m, n, rank),
                   B = random_matrix(m, 2, 5);
      EXPECT_LT(distance(pseudo_inverse(A), expected), 100.0 * kEps) << m << ' ' << n << ' ' << rank;
      EXPECT_LT(distance(least_norm_solve(A, B), product(expected, B)), 400.0 * kEps)
          << m << ' ' << n << ' ' << rank;
      const Vector b = random_vector(m, 5);
      EXPECT_LT(distance(least_norm_solve(A, b), product(expected, b)), 400.0 * kEps)
          << m << ' ' << n << ' ' << rank;
    }
  }
}

TEST(LeastSquares, HandOnWhatIsNotANumber) {
  Parabola problem(0.1);
  problem.A(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(any_nan(full_rank_least_squares(problem.A, problem.b)));
  EXPECT_TRUE(any_nan(householder_qr(problem.A).R));
  EXPECT_TRUE(any_nan(pivoted_least_squares(problem.A, problem.b)));
  EXPECT_TRUE(any_nan(least_norm_solve(problem.A, problem.b)));
  EXPECT_TRUE(any_nan(pseudo_inverse(problem.A)));
}

TEST(LeastSquares, OfNothing) {
  for (const int m : {0, 3}) {
    const Matrix none(m, 0);
    const Vector b = random_vector(m, 1);
    EXPECT_LT(distance_from_orthonormal(householder_basis(none)), kEps) << m;
    EXPECT_EQ(householder_basis(none).cols(), m);
    EXPECT_EQ(full_rank_least_squares(none, b).size(), 0) << m;
    EXPECT_EQ(pivoted_least_squares(none, b).size(), 0) << m;
    EXPECT_EQ(least_norm_solve(none, b).size(), 0) << m;
    EXPECT_EQ(pseudo_inverse(none).cols(), m);
  }
  const Matrix no_rows(0, 3);
  EXPECT_EQ(largest(least_norm_solve(no_rows, Vector(0))), 0.0);
  EXPECT_EQ(least_norm_solve(no_rows, Vector(0)).size(), 3);
}

}  // namespace
}  // namespace signorini::orthogonal_test
