#include "problems/linear_algebra/general_eigen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/problems/linear_algebra/known_matrices.hpp"

namespace signorini::general_eigen_test {
namespace {

using namespace test;

using Complex = std::complex<double>;

/// A x = shift of x by one place: eigenvalues are the roots of 1.
Matrix cyclic_shift(int size) {
  Matrix A = Matrix::Zero(size, size);
  for (int i = 0; i < size; ++i) A(i, (i + 1) % size) = 1.0;
  return A;
}

/// One damped oscillator per pair of rows, x'' + 2 zeta w x' + w^2 x = 0 with w = 1, 2, ...
Matrix oscillators(int pairs, double zeta) {
  Matrix A = Matrix::Zero(2 * pairs, 2 * pairs);
  for (int k = 0; k < pairs; ++k) {
    const double w = k + 1.0;
    A(2 * k, 2 * k + 1) = 1.0;
    A(2 * k + 1, 2 * k) = -w * w;
    A(2 * k + 1, 2 * k + 1) = -2.0 * zeta * w;
  }
  return A;
}

/// Of (mu - 1)(mu - 2) ... (mu - n), whose coefficients are integers that double holds for small n.
Matrix companion(int size) {
  std::vector<double> coefficients{1.0};  // from the constant one on
  for (int root = 1; root <= size; ++root) {
    coefficients.push_back(0.0);
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      coefficients[k] = (k > 0 ? coefficients[k - 1] : 0.0) - root * coefficients[k];
    }
  }
  Matrix A = Matrix::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    A(i, size - 1) = -coefficients[static_cast<std::size_t>(i)];
    if (i > 0) A(i, i - 1) = 1.0;
  }
  return A;
}

/// How far the worst of `expected` is from the values, each of which is taken once.
double mismatch(const Eigen::VectorXcd& values, const std::vector<Complex>& expected) {
  std::vector<Complex> left(values.begin(), values.end());
  if (left.size() != expected.size()) return std::numeric_limits<double>::infinity();
  double worst = 0.0;
  for (const Complex value : expected) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](Complex a, Complex b) {
      return std::abs(a - value) < std::abs(b - value);
    });
    worst = std::max(worst, std::abs(*nearest - value));
    left.erase(nearest);
  }
  return worst;
}

/// The largest entry of A x - mu x over all vectors x.
double residual(const Matrix& A, const GeneralEigen& found) {
  const int size = static_cast<int>(A.rows());
  Eigen::MatrixXcd complex(size, size), scaled(size, size);
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      complex(i, j) = A(i, j);
      scaled(i, j) = found.vectors(i, j) * found.values[j];
    }
  }
  return complex_distance(complex_product(complex, found.vectors), scaled);
}

void expect_unit_vectors(const Eigen::MatrixXcd& vectors) {
  for (int k = 0; k < static_cast<int>(vectors.cols()); ++k) {
    double square = 0.0;
    for (int i = 0; i < static_cast<int>(vectors.rows()); ++i) square += std::norm(vectors(i, k));
    EXPECT_NEAR(square, 1.0, 1e-13) << k;
  }
}

/// Each value that is not real is followed, or preceded, by its conjugate, with conjugate vectors.
void expect_pairs_from_above(const GeneralEigen& found) {
  for (int k = 0; k < static_cast<int>(found.values.size()); ++k) {
    if (found.values[k].imag() == 0.0) {
      for (int i = 0; i < static_cast<int>(found.values.size()); ++i) {
        EXPECT_EQ(found.vectors(i, k).imag(), 0.0) << k;
      }
      continue;
    }
    ASSERT_LT(k + 1, found.values.size());
    EXPECT_GT(found.values[k].imag(), 0.0) << k;
    EXPECT_EQ(found.values[k + 1], std::conj(found.values[k])) << k;
    for (int i = 0; i < static_cast<int>(found.values.size()); ++i) {
      EXPECT_EQ(found.vectors(i, k + 1), std::conj(found.vectors(i, k))) << k;
    }
    ++k;
  }
}

TEST(GeneralEigen, OfAShiftAreTheRootsOfOne) {
  for (const int size : kSizes) {
    const Matrix A = cyclic_shift(size);
    std::vector<Complex> expected;
    for (int k = 0; k < size; ++k) expected.push_back(std::polar(1.0, 2.0 * std::numbers::pi * k / size));
    const GeneralEigen found = general_eigen(A);
    ASSERT_TRUE(found.converged) << size;
    EXPECT_LT(mismatch(found.values, expected), 4.0 * kEps * size) << size;
    EXPECT_LT(mismatch(general_eigenvalues(A), expected), 4.0 * kEps * size) << size;
    EXPECT_LT(residual(A, found), 4.0 * kEps * size) << size;
    expect_unit_vectors(found.vectors);
    expect_pairs_from_above(found);
  }
}

TEST(GeneralEigen, OfDampedOscillators) {
  for (const int pairs : {1, 15, 16, 40}) {
    for (const double zeta : {0.05, 1.25}) {  // pairs, and real values
      const Matrix A = oscillators(pairs, zeta);
      std::vector<Complex> expected;
      for (int k = 0; k < pairs; ++k) {
        const Complex root = std::sqrt(Complex(zeta * zeta - 1.0));
        expected.push_back((k + 1.0) * (-zeta + root));
        expected.push_back((k + 1.0) * (-zeta - root));
      }
      const GeneralEigen found = general_eigen(A);
      ASSERT_TRUE(found.converged) << pairs;
      EXPECT_LT(mismatch(found.values, expected), 1e-12) << pairs << ' ' << zeta;
      EXPECT_LT(mismatch(general_eigenvalues(A), expected), 1e-12) << pairs << ' ' << zeta;
      expect_unit_vectors(found.vectors);
      expect_pairs_from_above(found);
      for (int k = 0; k < 2 * pairs; ++k) {  // x' = mu x, in one oscillator alone
        for (int i = 0; i < pairs; ++i) {
          const Complex x = found.vectors(2 * i, k), v = found.vectors(2 * i + 1, k);
          EXPECT_LT(std::abs(v - found.values[k] * x), 1e-12 * pairs) << pairs << ' ' << k;
        }
      }
    }
  }
}

TEST(GeneralEigen, OfRandomMatricesLeaveNoResidual) {
  for (const int size : kSizes) {
    const Matrix A = random_matrix(size, size, 5);
    const GeneralEigen found = general_eigen(A);
    ASSERT_TRUE(found.converged) << size;
    EXPECT_LT(residual(A, found), 8.0 * kEps * column_norm(A)) << size;
    expect_unit_vectors(found.vectors);
    expect_pairs_from_above(found);
    const Eigen::VectorXcd values = general_eigenvalues(A);
    EXPECT_LT(mismatch(values, std::vector<Complex>(found.values.begin(), found.values.end())),
              1e-12 * column_norm(A))
        << size;
    double trace = 0.0, sum = 0.0;
    for (int i = 0; i < size; ++i) {
      trace += A(i, i);
      sum += values[i].real();
    }
    EXPECT_NEAR(sum, trace, 8.0 * kEps * size * column_norm(A)) << size;
  }
}

TEST(GeneralEigen, OfACompanionMatrixAreTheRoots) {
  const Matrix A = companion(6);
  const GeneralEigen found = general_eigen(A);
  ASSERT_TRUE(found.converged);
  EXPECT_LT(mismatch(found.values, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}), 1e-10);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(found.values[k].imag(), 0.0);
}

// The one vector of a Jordan block comes n times; its value is found to the n-th root of rounding.
TEST(GeneralEigen, OfAJordanBlock) {
  for (const int size : {2, 4}) {
    Matrix A = Matrix::Zero(size, size);
    for (int i = 0; i < size; ++i) {
      A(i, i) = 3.0;
      if (i > 0) A(i, i - 1) = 1.0;
    }
    const GeneralEigen found = general_eigen(A);
    ASSERT_TRUE(found.converged) << size;
    EXPECT_LT(mismatch(found.values, std::vector<Complex>(static_cast<std::size_t>(size), 3.0)),
              10.0 * std::pow(kEps, 1.0 / size));
    expect_unit_vectors(found.vectors);
    EXPECT_LT(residual(A, found), 40.0 * kEps);
  }
}

TEST(GeneralEigen, OfWhatIsNotFiniteDoNotConverge) {
  for (const int size : kSizes) {
    for (const double entry :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      for (const int column : {0, size - 1}) {
        Matrix A = cyclic_shift(size);
        A(size - 1, column) = entry;
        EXPECT_FALSE(general_eigen(A).converged) << size << ' ' << column << ' ' << entry;
        const Eigen::VectorXcd values = general_eigenvalues(A);
        ASSERT_EQ(values.size(), size);
        for (const Complex value : values) {
          EXPECT_TRUE(std::isnan(value.real()) && std::isnan(value.imag())) << size;
        }
      }
    }
  }
}

TEST(LargestMagnitude, IsThatOfAnyEigenvalue) {
  EXPECT_EQ(largest_magnitude({}), 0.0);
  Eigen::VectorXcd values(3);
  values << std::complex<double>(0.3, 0.4), std::complex<double>(-2.0, 0.0), std::complex<double>(1.0, 0.0);
  EXPECT_EQ(largest_magnitude(values), 2.0);
}

TEST(GeneralEigen, OfNothing) {
  EXPECT_TRUE(general_eigen(Matrix(0, 0)).converged);
  EXPECT_EQ(general_eigenvalues(Matrix(0, 0)).size(), 0);
}

/// Pairs and real values of falling magnitude in blocks, in other coordinates that are not orthogonal.
Matrix with_values(const std::vector<Complex>& values) {
  const auto size = static_cast<int>(values.size());
  Matrix D = Matrix::Zero(size, size);
  for (int k = 0; k < size; ++k) {
    const Complex mu = values[static_cast<std::size_t>(k)];
    D(k, k) = mu.real();
    if (mu.imag() == 0.0) continue;
    D(k + 1, k + 1) = mu.real();
    D(k, k + 1) = -mu.imag();
    D(k + 1, k) = mu.imag();
    ++k;
  }
  const Matrix Q = orthogonal_matrix(size, 3);
  Matrix scaled = Q, inverse = transposed(Q);
  for (int k = 0; k < size; ++k) {
    const double unit = k % 3 == 0 ? 5.0 : 1.0;
    for (int i = 0; i < size; ++i) {
      scaled(k, i) *= unit;
      inverse(i, k) /= unit;
    }
  }
  return product(scaled, product(D, inverse));
}

/// Those of a rod whose modes are damped alike: |mu| = e^{-fall r}, r = 1, 3, 5, ... quarter waves.
std::vector<Complex> of_a_rod(int pairs, double fall) {
  std::vector<Complex> values;
  for (int k = 0; k < pairs; ++k) {
    const double r = 2.0 * k + 1.0;
    values.push_back(std::polar(std::exp(-fall * r), 0.9 + 0.7 * r * r));
    values.push_back(std::conj(values.back()));
  }
  return values;
}

void expect_leading(const Matrix& A, const std::vector<Complex>& values, Eigen::Index at_least) {
  const Eigen::VectorXcd found = leading_eigenvalues(A, 1e-10);
  ASSERT_GE(found.size(), at_least);
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    double nearest = 1e300;
    for (const Complex value : values) nearest = std::min(nearest, std::abs(value - found[k]));
    EXPECT_LT(nearest, 1e-9 * std::max(1.0, std::abs(found[0]))) << k;
    EXPECT_LE(std::abs(found[k]), std::abs(found[std::max<Eigen::Index>(k - 1, 0)])) << k;
  }
  // None is missing that is larger than the last one.
  const double least = std::abs(found[found.size() - 1]) * (1.0 + 1e-9);
  EXPECT_LE(std::ranges::count_if(values, [&](Complex value) { return std::abs(value) > least; }),
            found.size());
}

TEST(LeadingEigenvalues, AreTheLargestOfThoseOfAStructure) {
  std::vector<Complex> values = of_a_rod(32, 0.09);
  expect_leading(with_values(values), values, 8);
  values[0] = 3.0;  // two real ones, beyond the circle and on it
  values[1] = -1.0;
  expect_leading(with_values(values), values, 8);
  values[0] = values[1] = -1.2;  // twice
  expect_leading(with_values(values), values, 8);
}

TEST(LeadingEigenvalues, OfBothHalvesOfASymmetricStructureAreTwice) {
  const std::vector<Complex> half = of_a_rod(16, 0.15);
  std::vector<Complex> values = half;
  values.insert(values.end(), half.begin(), half.end());
  const Eigen::VectorXcd found = leading_eigenvalues(with_values(values), 1e-10);
  ASSERT_GE(found.size(), 4);
  EXPECT_LT(mismatch(found.head(4), {half[0], half[0], half[1], half[1]}), 1e-9);
}

TEST(LeadingEigenvalues, AreLeftOutWhereTheyAreNotKnown) {
  EXPECT_EQ(leading_eigenvalues(cyclic_shift(200), 1e-10).size(), 0) << "all of one magnitude";
  Matrix A = cyclic_shift(80);
  A(3, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(leading_eigenvalues(A, 1e-10).size(), 0);
  EXPECT_EQ(leading_eigenvalues(Matrix(0, 0), 1e-10).size(), 0);
}

TEST(LeadingEigenvalues, OfASmallMatrixAndOfOneOfSmallRankAreAllThatDiffer) {
  const std::vector<Complex> values{{0.5, 0.5}, {0.5, -0.5}, -0.3, 0.2, 0.1};
  const Eigen::VectorXcd found = leading_eigenvalues(with_values(values), 1e-10);
  ASSERT_EQ(found.size(), 5);
  EXPECT_LT(mismatch(found, values), 1e-12);
  std::vector<Complex> few(64, 0.0);
  few[0] = 1e8;  // beside a grazing
  few[1] = 0.6;
  expect_leading(with_values(few), few, 1);
}

}  // namespace
}  // namespace signorini::general_eigen_test
