#include "problems/linear_algebra/singular_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::singular_values_test {
namespace {

using namespace test;

/// Square, tall and wide, on both sides of kLeastForLapack in either number.
constexpr std::pair<int, int> kShapes[] = {{1, 1}, {2, 2},   {31, 31}, {32, 32}, {33, 33}, {80, 80}, {5, 2},
                                           {2, 5}, {80, 31}, {31, 80}, {80, 33}, {33, 80}, {40, 1},  {1, 40}};

/// n, n - 1, ..., 1.
Vector falling(int size) {
  Vector values(size);
  for (int k = 0; k < size; ++k) values[k] = size - k;
  return values;
}

/// The largest entry of A - U diag(s) V^T.
double residual(const Matrix& A, const SingularValues& found) {
  Matrix rebuilt(A.rows(), A.cols());
  for (int j = 0; j < static_cast<int>(A.cols()); ++j) {
    for (int i = 0; i < static_cast<int>(A.rows()); ++i) {
      double sum = 0.0;
      for (int k = 0; k < static_cast<int>(found.values.size()); ++k) {
        sum += found.U(i, k) * found.values[k] * found.V(j, k);
      }
      rebuilt(i, j) = sum;
    }
  }
  return distance(A, rebuilt);
}

void expect_shape(const Matrix& A, int rows, int columns) {
  ASSERT_EQ(A.rows(), rows);
  ASSERT_EQ(A.cols(), columns);
}

TEST(SingularValues, AreThoseThatTheMatrixIsMadeOf) {
  for (const auto& [m, n] : kShapes) {
    const int least = std::min(m, n);
    const Vector values = falling(least);
    const Matrix A = with_singular_values(m, n, values, 3);
    const SingularValues found = singular_vectors(A);
    ASSERT_EQ(found.values.size(), least);
    EXPECT_LT(distance(found.values, values), 100.0 * kEps * least) << m << ' ' << n;
    expect_shape(found.U, m, m);
    expect_shape(found.V, n, n);
    EXPECT_LT(distance_from_orthonormal(found.U), 100.0 * kEps) << m << ' ' << n;
    EXPECT_LT(distance_from_orthonormal(found.V), 100.0 * kEps) << m << ' ' << n;
    EXPECT_LT(residual(A, found), 100.0 * kEps * least) << m << ' ' << n;
    EXPECT_NEAR(least_singular_value(A), 1.0, 100.0 * kEps * least) << m << ' ' << n;
  }
}

TEST(SingularValues, WithTheLeftVectorsAloneAreTheSame) {
  for (const auto& [m, n] : kShapes) {
    const int least = std::min(m, n);
    const Vector values = falling(least);
    const Matrix A = with_singular_values(m, n, values, 3);
    const SingularValues left = left_singular_vectors(A);
    EXPECT_LT(distance(left.values, values), 100.0 * kEps * least) << m << ' ' << n;
    EXPECT_EQ(left.V.size(), 0);
    expect_shape(left.U, m, least);
    EXPECT_LT(distance_from_orthonormal(left.U), 100.0 * kEps) << m << ' ' << n;
    const Matrix turned = product(transposed(left.U), A);  // U^T A = diag(s) V^T
    const Matrix squares = product(turned, transposed(turned));
    for (int k = 0; k < least; ++k) {
      for (int i = 0; i < least; ++i) {
        EXPECT_NEAR(squares(i, k), i == k ? values[k] * values[k] : 0.0, 100.0 * kEps * least * least);
      }
    }
  }
}

// Of a matrix of rank r the last n - r span its null space.
TEST(SingularValues, SpanTheNullSpace) {
  for (const auto& [m, n] : kShapes) {
    for (const int rank : {0, std::min(m, n) / 2, std::min(m, n) - 1}) {
      Vector values(std::min(m, n));
      for (int k = 0; k < std::min(m, n); ++k) values[k] = k < rank ? 2.0 - 1.0 * k / n : 0.0;
      const Matrix A = with_singular_values(m, n, values, 3), V = right_singular_vectors(A);
      expect_shape(V, n, n);
      EXPECT_LT(distance_from_orthonormal(V), 100.0 * kEps) << m << ' ' << n;
      Matrix null(n, n - rank);
      for (int k = rank; k < n; ++k) {
        for (int i = 0; i < n; ++i) null(i, k - rank) = V(i, k);
      }
      EXPECT_LT(largest(product(A, null)), 100.0 * kEps) << m << ' ' << n << ' ' << rank;
      EXPECT_LT(least_singular_value(A), 20.0 * kEps) << m << ' ' << n << ' ' << rank;
    }
  }
}

TEST(SingularValues, OfALineOfSpringsAreSines) {
  for (const int size : kSizes) {  // of n + 1 springs, whose Gram matrix is the chain's stiffness
    Matrix stretches = Matrix::Zero(size + 1, size);
    for (int i = 0; i < size; ++i) {
      stretches(i, i) = 1.0;
      stretches(i + 1, i) = -1.0;
    }
    const SingularValues found = singular_vectors(stretches);
    for (int k = 0; k < size; ++k) {
      const double expected = std::sqrt(chain_eigenvalue(size, size - 1 - k));
      EXPECT_NEAR(found.values[k], expected, 100.0 * kEps) << size << ' ' << k;
      double worst = 0.0;
      const double sign = found.V(0, k) > 0.0 ? 1.0 : -1.0;
      for (int i = 0; i < size; ++i) {
        worst = std::max(worst, std::abs(sign * found.V(i, k) - chain_mode(size, i, size - 1 - k)));
      }
      EXPECT_LT(worst, 4.0 * kEps * size * size) << size << ' ' << k;
    }
  }
}

// Columns from 1 to 1e-12: values are right to the rounding of the largest.
TEST(SingularValues, OfGradedMatrices) {
  for (const int size : {2, 31, 33, 80}) {
    Vector values(size);
    for (int k = 0; k < size; ++k) values[k] = std::pow(10.0, -12.0 * k / (size - 1));
    const Matrix A = with_singular_values(size, size, values, 3);
    EXPECT_LT(distance(singular_vectors(A).values, values), 100.0 * kEps) << size;
    EXPECT_NEAR(least_singular_value(A), 1e-12, 20.0 * kEps) << size;
  }
}

TEST(SingularValues, OfWhatIsNotFiniteAreNotNumbers) {
  for (const auto& [m, n] : kShapes) {
    for (const double entry :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Matrix A = random_matrix(m, n, 1);
      A(m - 1, 0) = entry;
      const SingularValues found = singular_vectors(A), left = left_singular_vectors(A);
      ASSERT_EQ(found.values.size(), std::min(m, n));
      ASSERT_EQ(left.values.size(), std::min(m, n));
      expect_shape(found.U, m, m);
      expect_shape(found.V, n, n);
      expect_shape(left.U, m, std::min(m, n));
      EXPECT_TRUE(std::isnan(found.values[0]) && std::isnan(found.values[std::min(m, n) - 1]));
      EXPECT_TRUE(std::isnan(left.values[0]));
      EXPECT_TRUE(any_nan(right_singular_vectors(A)));
      EXPECT_TRUE(std::isnan(least_singular_value(A)));
    }
  }
}

TEST(SingularValues, OfNothing) {
  constexpr std::pair<int, int> kEmpty[] = {{0, 0}, {3, 0}, {0, 3}};
  for (const auto& [m, n] : kEmpty) {
    EXPECT_EQ(least_singular_value(Matrix(m, n)), std::numeric_limits<double>::infinity());
    EXPECT_EQ(singular_vectors(Matrix(m, n)).values.size(), 0);
    const Matrix V = right_singular_vectors(Matrix(m, n));
    expect_shape(V, n, n);
    EXPECT_LT(distance_from_orthonormal(V), kEps);
  }
}

}  // namespace
}  // namespace signorini::singular_values_test
