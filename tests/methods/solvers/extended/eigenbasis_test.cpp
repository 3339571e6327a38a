#include "methods/solvers/extended/eigenbasis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

namespace signorini::eigenbasis_test {
namespace {

using Complex = std::complex<long double>;
using Eigen::Index;
using extended::Eigenbasis;
using extended::eigenbasis;

constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

ExtendedMatrix zeros(Index n) {
  ExtendedMatrix A(n, n);
  std::fill_n(A.data(), n * n, 0.0L);
  return A;
}

long double grading(Index i) { return std::pow(10.0L, -static_cast<long double>(i)); }

ExtendedMatrix random_matrix(Index n) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::normal_distribution<long double> normal;
  ExtendedMatrix A(n, n);
  for (Index i = 0; i < n * n; ++i) A.data()[i] = normal(random);
  return A;
}

// x^n + c_n-1 x^n-1 + ... + c_0 has the eigenvalues of this matrix as its roots.
ExtendedMatrix companion(const std::vector<long double>& c) {
  const auto n = static_cast<Index>(c.size());
  ExtendedMatrix A = zeros(n);
  for (Index i = 0; i < n; ++i) {
    if (i > 0) A(i, i - 1) = 1.0L;
    A(i, n - 1) = -c[static_cast<std::size_t>(i)];
  }
  return A;
}

std::vector<Complex> values_of(const Eigenbasis& basis) {
  std::vector<Complex> values;
  for (std::size_t k = 0; k < basis.real.size(); ++k) values.emplace_back(basis.real[k], basis.imaginary[k]);
  return values;
}

// Every expected value is one that was found, each of which is taken once.
void expect_values(const ExtendedMatrix& A, std::vector<Complex> expected, long double bound) {
  const auto basis = eigenbasis(A);
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->real.size(), expected.size());
  for (const Complex value : values_of(*basis)) {
    const auto nearest = std::min_element(expected.begin(), expected.end(), [value](Complex a, Complex b) {
      return std::abs(a - value) < std::abs(b - value);
    });
    EXPECT_LE(std::abs(*nearest - value), bound) << value;
    expected.erase(nearest);
  }
}

// By direct sums: A X = X Lambda and unit vectors within n roundings of |A|, X^-1 X = I within `condition`
// times as many; pairs stand side by side.
void expect_basis_of(const ExtendedMatrix& A, const Eigenbasis& basis, long double condition) {
  const Index n = A.rows();
  const ExtendedMatrix &X = basis.vectors, &Y = basis.inverse;
  const auto roundings = static_cast<long double>(n) * kRounding;
  long double residual = 0.0L, error = 0.0L, size = 0.0L;
  for (Index k = 0; k < n; ++k) {
    const auto of_k = static_cast<std::size_t>(k);
    const long double re = basis.real[of_k], im = basis.imaginary[of_k];
    const bool second = im < 0.0L, single = im == 0.0L;
    if (second) {
      ASSERT_GT(k, 0);
      EXPECT_EQ(basis.imaginary[of_k - 1], -im);
      EXPECT_EQ(basis.real[of_k - 1], re);
    }
    long double square = 0.0L;
    for (Index i = 0; i < n; ++i) {
      // A a = re a - im b and A b = im a + re b, b the next column of a.
      long double rest = -re * X(i, k), product = i == k ? -1.0L : 0.0L;
      if (!single) rest += im * X(i, second ? k - 1 : k + 1);
      for (Index j = 0; j < n; ++j) {
        rest += A(i, j) * X(j, k);
        product += Y(i, j) * X(j, k);
      }
      residual += rest * rest;
      error += product * product;
      size += A(i, k) * A(i, k);
      square += X(i, k) * X(i, k);
      if (!single) square += X(i, second ? k - 1 : k + 1) * X(i, second ? k - 1 : k + 1);
    }
    EXPECT_LT(std::abs(square - 1.0L), 4.0L * roundings);
  }
  EXPECT_LE(std::sqrt(residual), 4.0L * roundings * std::sqrt(size)) << n << " coordinates";
  EXPECT_LE(std::sqrt(error), condition * roundings) << n << " coordinates";
}

TEST(Eigenbasis, OfCompanionMatricesAreTheRoots) {
  // (x - 1) (x - 2) (x - 3) (x - 4), (x^2 + 1) (x - 2), (x^2 + 2x + 5) (x^2 + 4)
  expect_values(companion({24.0L, -50.0L, 35.0L, -10.0L}), {1.0L, 2.0L, 3.0L, 4.0L}, 1e-15L);
  expect_values(companion({-2.0L, 1.0L, -2.0L}), {{0.0L, 1.0L}, {0.0L, -1.0L}, 2.0L}, 1e-17L);
  expect_values(companion({20.0L, 8.0L, 9.0L, 2.0L}),
                {{-1.0L, 2.0L}, {-1.0L, -2.0L}, {0.0L, 2.0L}, {0.0L, -2.0L}}, 1e-16L);
}

TEST(Eigenbasis, OfACycleAreTheRootsOfUnity) {
  // A QR step maps a permutation to itself: shifts have to leave the circle.
  for (const int n : {1, 2, 3, 4, 8, 23, 24}) {
    std::vector<long double> c(static_cast<std::size_t>(n), 0.0L);
    c[0] = -1.0L;
    std::vector<Complex> expected;
    for (int k = 0; k < n; ++k)
      expected.push_back(std::polar(1.0L, 2.0L * std::numbers::pi_v<long double> * k / n));
    expect_values(companion(c), expected, 4.0L * n * kRounding);
    expect_basis_of(companion(c), eigenbasis(companion(c)).value(), 4.0L);
  }
}

TEST(Eigenbasis, OfARotationIsAPair) {
  for (const long double angle : {0.1L, 1.0L, 3.0L}) {
    ExtendedMatrix A(2, 2);
    A(0, 0) = A(1, 1) = std::cos(angle);
    A(1, 0) = std::sin(angle);
    A(0, 1) = -A(1, 0);
    expect_values(A, {std::polar(1.0L, angle), std::polar(1.0L, -angle)}, 2.0L * kRounding);
    expect_basis_of(A, eigenbasis(A).value(), 1.0L);
  }
}

TEST(Eigenbasis, OfASkewMatrixIsImaginary) {
  // Two sorts of coordinates that turn into each other: the diagonal is zero from the first step on.
  for (const Index n : {3, 12}) {
    ExtendedMatrix A = zeros(2 * n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j <= i; ++j) {
        A(j, n + i) = 1.0L / static_cast<long double>(1 + i - j);
        A(n + i, j) = -A(j, n + i);
      }
    }
    const auto basis = eigenbasis(A);
    ASSERT_TRUE(basis);
    expect_basis_of(A, *basis, 4.0L);
    for (const Complex value : values_of(*basis)) {
      EXPECT_LT(std::abs(value.real()), 50.0L * kRounding);
      EXPECT_GT(std::abs(value.imag()), 0.1L);
    }
  }
}

TEST(Eigenbasis, SolvesItsEquation) {
  for (const Index n : {1, 2, 3, 4, 5, 6, 7, 12, 24, 40}) {
    const ExtendedMatrix A = random_matrix(n);
    const auto basis = eigenbasis(A);
    ASSERT_TRUE(basis);
    expect_basis_of(A, *basis, 40.0L);
    EXPECT_TRUE(n < 12 || *std::max_element(basis->imaginary.begin(), basis->imaginary.end()) > 0.0L);
  }
}

TEST(Eigenbasis, OfRepeatedValuesIsABasis) {
  for (const Index n : {1, 3, 6}) {
    expect_basis_of(zeros(n), eigenbasis(zeros(n)).value(), 1.0L);
    expect_basis_of(extended::identity(n), eigenbasis(extended::identity(n)).value(), 1.0L);
  }
  // Twice the pair +-2i and the value 3 of another basis: S A S^-1 with S of ones above its diagonal.
  constexpr Index n = 6;
  ExtendedMatrix A = zeros(n);
  for (const Index k : {0, 3}) {
    A(k, k + 1) = 2.0L;
    A(k + 1, k) = -2.0L;
    A(k + 2, k + 2) = 3.0L;
  }
  for (Index k = n - 1; k > 0; --k) {
    for (Index j = 0; j < n; ++j) A(k - 1, j) += A(k, j);
    for (Index i = 0; i < n; ++i) A(i, k) -= A(i, k - 1);
  }
  expect_values(A, {{0.0L, 2.0L}, {0.0L, -2.0L}, {0.0L, 2.0L}, {0.0L, -2.0L}, 3.0L, 3.0L}, 1e-16L);
  expect_basis_of(A, eigenbasis(A).value(), 1e3L);
}

TEST(Eigenbasis, SaysHowNearItIsToDefective) {
  // 1 +- 1e-6, of vectors an angle of 2e-6 apart.
  ExtendedMatrix A = extended::identity(2);
  A(0, 1) = 1.0L;
  A(1, 0) = 1e-12L;
  expect_values(A, {1.0L + 1e-6L, 1.0L - 1e-6L}, 1e-12L);
  const auto condition = [](const Eigenbasis& basis, Index k) {
    long double right = 0.0L, left = 0.0L;
    for (Index i = 0; i < basis.vectors.rows(); ++i) {
      right += basis.vectors(i, k) * basis.vectors(i, k);
      left += basis.inverse(k, i) * basis.inverse(k, i);
    }
    return std::sqrt(right * left);
  };
  const auto basis = eigenbasis(A);
  for (const Index k : {0, 1}) EXPECT_NEAR(static_cast<double>(condition(*basis, k) / 0.5e6L), 1.0, 1e-6);
  // One vector for three values.
  ExtendedMatrix jordan = zeros(3);
  for (Index i = 0; i < 3; ++i) jordan(i, i) = 2.0L;
  jordan(0, 1) = jordan(1, 2) = 1.0L;
  for (const bool turned : {false, true}) {
    const auto defective = eigenbasis(turned ? extended::transposed(jordan) : jordan);
    EXPECT_TRUE(!defective || condition(*defective, 0) > 1e6L);
  }
}

TEST(Eigenbasis, OfAGradedMatrixIsAccurateInItsNorm) {
  constexpr Index n = 10;
  ExtendedMatrix A = random_matrix(n);
  for (Index i = 0; i < n * n; ++i) A.data()[i] *= grading(i % n) * grading(i / n);
  const auto basis = eigenbasis(A);
  ASSERT_TRUE(basis);
  expect_basis_of(A, *basis, 1e3L);
  // A triangle has its diagonal, over 30 decades.
  for (Index j = 0; j < n; ++j) std::fill_n(A.data() + j * n + j + 1, n - j - 1, 0.0L);
  for (Index i = 0; i < n; ++i) A(i, i) = std::pow(10.0L, static_cast<long double>(3 * ((3 * i) % n)));
  const auto triangle = eigenbasis(A);
  ASSERT_TRUE(triangle);
  for (Index i = 0; i < n; ++i) {
    const auto is_entry = [&](long double value) {
      return std::abs(value / A(i, i) - 1.0L) <= 2.0L * kRounding;
    };
    EXPECT_EQ(std::count_if(triangle->real.begin(), triangle->real.end(), is_entry), 1);
  }
}

TEST(Eigenbasis, IsNoneOfWhatIsNotFinite) {
  for (const Index n : {1, 2, 5}) {
    for (const long double value :
         {std::numeric_limits<long double>::quiet_NaN(), std::numeric_limits<long double>::infinity()}) {
      ExtendedMatrix A = random_matrix(n);
      A(n - 1, 0) = value;
      EXPECT_FALSE(eigenbasis(A));
    }
  }
  // Squares of entries overflow: the steps lead nowhere, and end.
  ExtendedMatrix huge = random_matrix(8);
  for (Index i = 0; i < huge.size(); ++i) huge.data()[i] *= 1e4000L;
  EXPECT_FALSE(eigenbasis(huge));
  EXPECT_TRUE(eigenbasis(ExtendedMatrix(0, 0))->real.empty());
}

}  // namespace
}  // namespace signorini::eigenbasis_test
