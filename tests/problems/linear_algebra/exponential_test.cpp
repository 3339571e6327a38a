#include "problems/linear_algebra/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::exponential_test {
namespace {

using namespace test;

TEST(MatrixExponential, OfASkewMatrixIsARotation) {
  for (const double angle : {1e-9, 0.3, 2.0, 40.0}) {
    Matrix A(2, 2), expected(2, 2);
    A << 0.0, -angle, angle, 0.0;
    expected << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Matrix result = matrix_exponential(A);
    double square = 0.0;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) square += std::pow(result(i, j) - expected(i, j), 2);
    }
    EXPECT_LT(std::sqrt(square), 1e-15 * (4.0 + angle)) << angle;
  }
}

// A mass that sticks leaves no coordinate free.
TEST(MatrixExponential, OfNothingIsNothing) {
  EXPECT_EQ(matrix_exponential(Eigen::MatrixXd(0, 0)).size(), 0);
}

TEST(MatrixExponential, OfANilpotentMatrixIsItsTaylorSum) {
  Matrix N(3, 3), expected(3, 3);
  N << 0.0, 2.0, 3.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0;
  expected << 1.0, 2.0, 3.0 + 0.5 * 2.0 * 4.0, 0.0, 1.0, 4.0, 0.0, 0.0, 1.0;
  const Matrix result = matrix_exponential(N);
  double square = 0.0;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) square += std::pow(result(i, j) - expected(i, j), 2);
  }
  EXPECT_LT(std::sqrt(square), 1e-14);
}

TEST(MatrixExponential, OfADiagonalMatrixActsElementByElement) {
  const double rates[] = {-30.0, 0.0, 2.0};
  Matrix A = Matrix::Zero(3, 3);
  for (int i = 0; i < 3; ++i) A(i, i) = rates[i];
  const Matrix result = matrix_exponential(A);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(result(i, i) / std::exp(rates[i]), 1.0, 1e-13);
}

// From one approximant to the next, each of which has norms of its own, and on to many squarings.
TEST(MatrixExponential, OfAJordanBlockOfAnyNorm) {
  for (const double norm :
       {0.0, 1e-300, 1e-8, 0.014, 0.016, 0.2, 0.3, 0.9, 1.0, 2.0, 2.2, 5.0, 6.0, 30.0, 600.0}) {
    for (const double sign : {-1.0, 1.0}) {
      Matrix A(2, 2);  // e^(a I + N) = e^a (I + N)
      const double a = sign * 0.5 * norm, b = 0.5 * norm;
      A << a, b, 0.0, a;
      const Matrix result = matrix_exponential(A);
      const double scale = std::exp(a);
      EXPECT_NEAR(result(0, 0) / scale, 1.0, 4.0 * kEps * (1.0 + norm)) << norm;
      EXPECT_NEAR(result(1, 1) / scale, 1.0, 4.0 * kEps * (1.0 + norm)) << norm;
      EXPECT_NEAR(result(0, 1) / scale, b, 4.0 * kEps * (1.0 + norm) * (1.0 + b)) << norm;
      EXPECT_EQ(result(1, 0), 0.0) << norm;
    }
  }
}

TEST(MatrixExponential, OfASpringChainIsASumOfItsModes) {
  for (const int size : kSizes) {
    for (const double time : {0.01, 1.0, 25.0}) {
      Matrix A = spring_chain(size), expected(size, size);
      for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
          A(i, j) *= -time;
          expected(i, j) = 0.0;
          for (int k = 0; k < size; ++k) {
            expected(i, j) +=
                chain_mode(size, i, k) * chain_mode(size, j, k) * std::exp(-time * chain_eigenvalue(size, k));
          }
        }
      }
      EXPECT_LT(distance(matrix_exponential(A), expected), 20.0 * kEps * (1.0 + time)) << size << ' ' << time;
    }
  }
}

TEST(MatrixExponential, OfWhatIsNotANumberIsNone) {
  for (const int size : {1, 2, 33}) {
    Matrix A = spring_chain(size);
    A(size - 1, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(any_nan(matrix_exponential(A))) << size;
  }
}

}  // namespace
}  // namespace signorini::exponential_test
