#include "methods/solvers/extended/symmetric_eigenpairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace signorini::symmetric_eigenpairs_test {
namespace {

using Eigen::Index;
using extended::symmetric_eigenpairs;
using extended::SymmetricEigenpairs;

constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

ExtendedMatrix constant(Index n, long double value) {
  ExtendedMatrix A(n, n);
  std::fill_n(A.data(), n * n, value);
  return A;
}

long double grading(Index i) { return std::pow(10.0L, -static_cast<long double>(i)); }

ExtendedMatrix random_matrix(Index n) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::normal_distribution<long double> normal;
  ExtendedMatrix A(n, n);
  for (Index j = 0; j < n; ++j) {
    for (Index i = j; i < n; ++i) A(i, j) = A(j, i) = normal(random);
  }
  return A;
}

// A V = V diag(values) and V^T V = I, by direct sums, within n roundings.
void expect_pairs_of(const ExtendedMatrix& A, const SymmetricEigenpairs& pairs) {
  const Index n = A.rows();
  const ExtendedMatrix& V = pairs.vectors;
  ASSERT_EQ(std::ssize(pairs.values), n);
  ASSERT_EQ(V.rows(), n);
  ASSERT_EQ(V.cols(), n);
  EXPECT_TRUE(std::is_sorted(pairs.values.begin(), pairs.values.end()));
  long double residual = 0.0L, coupling = 0.0L, size = 0.0L;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i) {
      long double rest = -V(i, j) * pairs.values[static_cast<std::size_t>(j)],
                  product = i == j ? -1.0L : 0.0L;
      for (Index k = 0; k < n; ++k) {
        rest += A(i, k) * V(k, j);
        product += V(k, i) * V(k, j);
      }
      residual += rest * rest;
      coupling += product * product;
      size += A(i, j) * A(i, j);
    }
  }
  const auto roundings = kRounding * static_cast<long double>(n);
  EXPECT_LE(std::sqrt(residual), 2.0L * roundings * std::sqrt(size)) << n << " coordinates";
  EXPECT_LE(std::sqrt(coupling), 4.0L * roundings) << n << " coordinates";
}

TEST(SymmetricEigenpairs, OfAChainOfSpringsAreSines) {
  for (const Index n : {1, 2, 3, 12, 50}) {
    ExtendedMatrix K = constant(n, 0.0L);
    for (Index i = 0; i < n; ++i) {
      K(i, i) = 2.0L;
      if (i > 0) K(i, i - 1) = K(i - 1, i) = -1.0L;
    }
    const auto pairs = symmetric_eigenpairs(K);
    ASSERT_TRUE(pairs);
    expect_pairs_of(K, *pairs);
    for (Index k = 1; k <= n; ++k) {
      const long double angle =
          std::numbers::pi_v<long double> * static_cast<long double>(k) / static_cast<long double>(n + 1);
      const long double half = std::sin(0.5L * angle);
      EXPECT_LT(std::abs(pairs->values[static_cast<std::size_t>(k - 1)] - 4.0L * half * half),
                static_cast<long double>(8 + 2 * n) * kRounding);
      const long double sign = std::copysign(1.0L, pairs->vectors(0, k - 1));
      for (Index i = 0; i < n; ++i) {
        const long double sine = std::sin(angle * static_cast<long double>(i + 1));
        EXPECT_NEAR(static_cast<double>(sign * pairs->vectors(i, k - 1) -
                                        sine * std::sqrt(2.0L / static_cast<long double>(n + 1))),
                    0.0, 1e-15);
      }
    }
  }
}

TEST(SymmetricEigenpairs, SolveTheirEquation) {
  for (const Index n : {1, 2, 3, 4, 5, 11, 12, 40, 101}) {
    const ExtendedMatrix A = random_matrix(n);
    const auto pairs = symmetric_eigenpairs(A);
    ASSERT_TRUE(pairs);
    expect_pairs_of(A, *pairs);
  }
}

TEST(SymmetricEigenpairs, OfRepeatedValuesAreOrthogonal) {
  for (const Index n : {2, 7, 30}) {
    ExtendedMatrix A = constant(n, 1.0L);  // n once, else 0
    for (const long double shift : {0.0L, 3.0L}) {
      for (Index i = 0; i < n; ++i) A(i, i) += shift;
      const auto pairs = symmetric_eigenpairs(A);
      ASSERT_TRUE(pairs);
      expect_pairs_of(A, *pairs);
      const auto bound = 2.0L * kRounding * static_cast<long double>(n * n);
      EXPECT_LT(std::abs(pairs->values[static_cast<std::size_t>(n - 2)] - shift), bound);
      EXPECT_LT(std::abs(pairs->values.back() - shift - static_cast<long double>(n)), bound);
    }
    expect_pairs_of(constant(n, 0.0L), symmetric_eigenpairs(constant(n, 0.0L)).value());
    expect_pairs_of(extended::identity(n), symmetric_eigenpairs(extended::identity(n)).value());
  }
}

TEST(SymmetricEigenpairs, OfADiagonalMatrixAreItsEntriesHoweverGraded) {
  constexpr Index n = 20;
  ExtendedMatrix A = constant(n, 0.0L);
  for (Index i = 0; i < n; ++i) A(i, i) = std::pow(10.0L, static_cast<long double>(60 - 7 * ((3 * i) % n)));
  const auto pairs = symmetric_eigenpairs(A);
  ASSERT_TRUE(pairs);
  expect_pairs_of(A, *pairs);
  for (Index i = 0; i < n; ++i) {
    const auto is_entry = [&](long double value) {
      return std::abs(value / A(i, i) - 1.0L) <= 2.0L * kRounding;
    };
    EXPECT_EQ(std::count_if(pairs->values.begin(), pairs->values.end(), is_entry), 1) << i;
  }
  // Graded and coupled.
  const ExtendedMatrix coupled = random_matrix(n);
  for (Index i = 0; i < n * n; ++i) A.data()[i] = coupled.data()[i] * grading(i % n) * grading(i / n);
  expect_pairs_of(A, symmetric_eigenpairs(A).value());
}

TEST(SymmetricEigenpairs, ReadTheLowerTriangleAlone) {
  ExtendedMatrix A = random_matrix(6);
  const auto expected = symmetric_eigenpairs(A);
  for (Index j = 0; j < 6; ++j) std::fill_n(A.data() + 6 * j, j, 1e9L);
  EXPECT_EQ(symmetric_eigenpairs(A)->values, expected->values);
}

TEST(SymmetricEigenpairs, AreNoneOfWhatIsNotFinite) {
  for (const Index n : {1, 2, 5}) {
    for (const long double value :
         {std::numeric_limits<long double>::quiet_NaN(), std::numeric_limits<long double>::infinity()}) {
      ExtendedMatrix A = random_matrix(n);
      A(n - 1, 0) = value;
      EXPECT_FALSE(symmetric_eigenpairs(A));
    }
  }
  // Squares of entries would overflow.
  ExtendedMatrix huge = random_matrix(8);
  const auto expected = symmetric_eigenpairs(huge);
  for (Index i = 0; i < huge.size(); ++i) huge.data()[i] *= 1e4000L;
  const auto pairs = symmetric_eigenpairs(huge);
  ASSERT_TRUE(pairs);
  for (std::size_t k = 0; k < 8; ++k)
    EXPECT_NEAR(static_cast<double>(pairs->values[k] * 1e-4000L / expected->values[k]), 1.0, 1e-15);
  EXPECT_TRUE(symmetric_eigenpairs(ExtendedMatrix(0, 0))->values.empty());
}

}  // namespace
}  // namespace signorini::symmetric_eigenpairs_test
