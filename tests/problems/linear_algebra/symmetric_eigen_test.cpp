#include "problems/linear_algebra/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::symmetric_eigen_test {
namespace {

using namespace test;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Matrix lower_part(Matrix A) {
  for (int j = 0; j < static_cast<int>(A.cols()); ++j) {
    for (int i = 0; i < j; ++i) A(i, j) = 1e3;
  }
  return A;
}

/// m_i = 1, 2, 3, 1, ... on the diagonal.
Matrix masses(int size) {
  Matrix M = Matrix::Zero(size, size);
  for (int i = 0; i < size; ++i) M(i, i) = 1.0 + i % 3;
  return M;
}

/// D A D with D = diag(1 + i % 2, ...): a congruence that keeps the eigenvalues of a pair (A, B).
Matrix scaled(Matrix A) {
  for (int j = 0; j < static_cast<int>(A.cols()); ++j) {
    for (int i = 0; i < static_cast<int>(A.rows()); ++i) A(i, j) *= (1.0 + i % 2) * (1.0 + j % 2);
  }
  return A;
}

/// The largest entry of A X - B X diag(values).
double residual(const Matrix& A, const Matrix& B, const SymmetricEigen& found) {
  Matrix right = product(B, found.vectors);
  for (int k = 0; k < static_cast<int>(right.cols()); ++k) {
    for (int i = 0; i < static_cast<int>(right.rows()); ++i) right(i, k) *= found.values[k];
  }
  return distance(product(A, found.vectors), right);
}

void expect_no_values(const Vector& values, int size) {
  ASSERT_EQ(values.size(), size);
  for (int k = 0; k < size; ++k) EXPECT_TRUE(std::isnan(values[k])) << size << ' ' << k;
}

TEST(SymmetricEigen, OfASpringChainAreSines) {
  for (const int size : kSizes) {
    const Matrix A = spring_chain(size);
    const SymmetricEigen found = symmetric_eigen(lower_part(A));
    ASSERT_TRUE(found.converged) << size;
    ASSERT_EQ(found.values.size(), size);
    const Vector values = symmetric_eigenvalues(lower_part(A));
    ASSERT_EQ(values.size(), size);
    for (int k = 0; k < size; ++k) {
      EXPECT_NEAR(found.values[k], chain_eigenvalue(size, k), 80.0 * kEps) << size << ' ' << k;
      EXPECT_NEAR(values[k], chain_eigenvalue(size, k), 80.0 * kEps) << size << ' ' << k;
      const double sign = found.vectors(0, k) > 0.0 ? 1.0 : -1.0;
      double worst = 0.0;  // eigenvalues are 3 pi^2 / n^2 apart at the least
      for (int i = 0; i < size; ++i) {
        worst = std::max(worst, std::abs(sign * found.vectors(i, k) - chain_mode(size, i, k)));
      }
      EXPECT_LT(worst, 4.0 * kEps * size * size) << size << ' ' << k;
    }
  }
}

// Full, of both signs, with values that come twice: vectors have to be orthonormal there as well.
TEST(SymmetricEigen, KeepMultipleValuesApart) {
  for (const int size : kSizes) {
    const Matrix Q = orthogonal_matrix(size, 3);
    Matrix D = Matrix::Zero(size, size);
    for (int k = 0; k < size; ++k) {
      const int value = k / 2 - size / 4;
      D(k, k) = value;
    }
    const Matrix A = product(product(Q, D), transposed(Q));
    const SymmetricEigen found = symmetric_eigen(A);
    ASSERT_TRUE(found.converged) << size;
    for (int k = 0; k < size; ++k) EXPECT_NEAR(found.values[k], D(k, k), 4.0 * kEps * size) << size;
    EXPECT_LT(distance_from_orthonormal(found.vectors), 40.0 * kEps) << size;
    EXPECT_LT(residual(A, Matrix::Identity(size, size), found), 8.0 * kEps * size) << size;
  }
}

TEST(SymmetricEigen, OfTheZeroMatrix) {
  for (const int size : kSizes) {
    const SymmetricEigen found = symmetric_eigen(Matrix::Zero(size, size));
    ASSERT_TRUE(found.converged) << size;
    EXPECT_EQ(largest(found.values), 0.0) << size;
    EXPECT_LT(distance_from_orthonormal(found.vectors), kEps) << size;
  }
}

TEST(SymmetricEigen, OfVerySmallAndVeryLargeMatrices) {
  for (const int size : {2, 31, 33}) {
    for (const double scale : {1e-200, 1e200}) {
      Matrix A = spring_chain(size);
      for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) A(i, j) *= scale;
      }
      const Vector values = symmetric_eigenvalues(A);
      for (int k = 0; k < size; ++k) {
        EXPECT_NEAR(values[k] / scale, chain_eigenvalue(size, k), 80.0 * kEps) << size;
      }
    }
  }
}

TEST(SymmetricEigen, OfWhatIsNotFiniteDoNotConverge) {
  for (const int size : kSizes) {
    for (const double entry : {kNone, kInfinity}) {
      for (const int column : {0, size - 1}) {
        Matrix A = spring_chain(size);
        A(size - 1, column) = entry;
        EXPECT_FALSE(symmetric_eigen(A).converged) << size << ' ' << column << ' ' << entry;
        expect_no_values(symmetric_eigenvalues(A), size);
      }
    }
  }
}

TEST(SymmetricEigen, OfNothing) {
  EXPECT_TRUE(symmetric_eigen(Matrix(0, 0)).converged);
  EXPECT_EQ(symmetric_eigenvalues(Matrix(0, 0)).size(), 0);
  EXPECT_TRUE(generalised_eigen(Matrix(0, 0), Matrix(0, 0)).converged);
}

TEST(GeneralisedEigen, OfAScaledSpringChainAreThoseOfTheChain) {
  for (const int size : kSizes) {
    const Matrix A = scaled(spring_chain(size)), B = scaled(Matrix::Identity(size, size));
    const SymmetricEigen found = generalised_eigen(lower_part(A), lower_part(B));
    ASSERT_TRUE(found.converged) << size;
    ASSERT_EQ(found.values.size(), size);
    for (int k = 0; k < size; ++k) {
      EXPECT_NEAR(found.values[k], chain_eigenvalue(size, k), 80.0 * kEps) << size << ' ' << k;
      const double sign = found.vectors(0, k) > 0.0 ? 1.0 : -1.0;
      double worst = 0.0;
      for (int i = 0; i < size; ++i) {
        const double expected = chain_mode(size, i, k) / (1.0 + i % 2);
        worst = std::max(worst, std::abs(sign * found.vectors(i, k) - expected));
      }
      EXPECT_LT(worst, 4.0 * kEps * size * size) << size << ' ' << k;
    }
  }
}

// A full B, and an A that is not definite: x^T A x = lambda, x^T B x = 1.
TEST(GeneralisedEigen, AreNormalisedByTheSecondMatrix) {
  for (const int size : kSizes) {
    const Matrix C = random_matrix(size, size, 1);
    Matrix A = C, B = masses(size);
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        A(i, j) = C(i, j) + C(j, i);
        B(i, j) += std::pow(0.5, std::abs(i - j));
      }
    }
    const SymmetricEigen found = generalised_eigen(A, B);
    ASSERT_TRUE(found.converged) << size;
    const Matrix gram = product(transposed(found.vectors), product(B, found.vectors));
    EXPECT_LT(distance(gram, Matrix::Identity(size, size)), 100.0 * kEps) << size;
    EXPECT_LT(residual(A, B, found), 20.0 * kEps * size) << size;
    for (int k = 1; k < size; ++k) EXPECT_LE(found.values[k - 1], found.values[k]) << size;
  }
}

TEST(GeneralisedEigen, OfASecondMatrixThatIsNotDefiniteDoNotConverge) {
  for (const int size : kSizes) {
    for (const int place : {0, size / 2, size - 1}) {
      for (const double mass : {0.0, -1.0}) {
        Matrix B = masses(size);
        B(place, place) = mass;
        EXPECT_FALSE(generalised_eigen(spring_chain(size), B).converged) << size << ' ' << place;
      }
    }
  }
}

TEST(GeneralisedEigen, OfWhatIsNotFiniteDoNotConverge) {
  for (const int size : kSizes) {
    for (const int column : {0, size - 1}) {
      Matrix A = spring_chain(size), B = masses(size);
      A(size - 1, column) = kNone;
      EXPECT_FALSE(generalised_eigen(A, masses(size)).converged) << size << ' ' << column;
      B(size - 1, column) = kNone;
      EXPECT_FALSE(generalised_eigen(spring_chain(size), B).converged) << size << ' ' << column;
    }
  }
}

}  // namespace
}  // namespace signorini::symmetric_eigen_test
