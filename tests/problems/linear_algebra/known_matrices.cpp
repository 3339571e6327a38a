#include "tests/problems/linear_algebra/known_matrices.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

namespace signorini::test {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Entry>
auto made(int rows, int columns, const Entry& entry) {
  Eigen::Matrix<decltype(entry(0, 0)), Eigen::Dynamic, Eigen::Dynamic> A(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) A(i, j) = entry(i, j);
  }
  return A;
}

int rows(const auto& A) { return static_cast<int>(A.rows()); }
int columns(const auto& A) { return static_cast<int>(A.cols()); }

template <class A>
double largest_difference(const A& one, const A& other) {
  if (one.rows() != other.rows() || one.cols() != other.cols()) return kNone;
  double result = 0.0;
  for (int j = 0; j < columns(one); ++j) {
    for (int i = 0; i < rows(one); ++i) {
      const double difference = std::abs(one(i, j) - other(i, j));
      if (std::isnan(difference)) return kNone;
      result = std::max(result, difference);
    }
  }
  return result;
}

}  // namespace

Matrix random_matrix(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return made(rows, columns, [&](int, int) { return normal(random); });
}

Vector random_vector(int size, unsigned seed) {
  const Matrix entries = random_matrix(size, 1, seed);
  Vector result(size);
  for (int i = 0; i < size; ++i) result[i] = entries(i, 0);
  return result;
}

Matrix spring_chain(int size) {
  return made(size, size, [](int i, int j) { return i == j ? 2.0 : std::abs(i - j) == 1 ? -1.0 : 0.0; });
}

double chain_eigenvalue(int size, int k) {
  const double half = std::sin((k + 1) * std::numbers::pi / (2 * (size + 1)));
  return 4.0 * half * half;
}

double chain_mode(int size, int i, int k) {
  return std::sqrt(2.0 / (size + 1)) * std::sin((i + 1) * (k + 1) * std::numbers::pi / (size + 1));
}

double chain_flexibility(int size, int i, int j) {
  return (std::min(i, j) + 1.0) * (size - std::max(i, j)) / (size + 1.0);
}

Matrix least_index_matrix(int size) {
  return made(size, size, [](int i, int j) { return std::min(i, j) + 1.0; });
}

Matrix least_index_inverse(int size) {
  Matrix A = spring_chain(size);
  if (size > 0) A(size - 1, size - 1) = 1.0;
  return A;
}

Matrix lower_ones(int size) {
  return made(size, size, [](int i, int j) { return i >= j ? 1.0 : 0.0; });
}

// Each reflection I - 2 v v^T / v^T v is applied in long double, so that rounding is that of the end.
Matrix orthogonal_matrix(int size, unsigned seed) {
  auto Q = made(size, size, [](int i, int j) { return i == j ? 1.0L : 0.0L; });
  for (unsigned round = 0; round < 3; ++round) {
    const Vector v = random_vector(size, seed + 100 * round);
    long double square = 0.0L;
    for (int i = 0; i < size; ++i) square += static_cast<long double>(v[i]) * v[i];
    for (int j = 0; j < size; ++j) {
      long double along = 0.0L;
      for (int i = 0; i < size; ++i) along += Q(i, j) * v[i];
      for (int i = 0; i < size; ++i) Q(i, j) -= 2.0L * along * v[i] / square;
    }
  }
  return made(size, size, [&](int i, int j) { return static_cast<double>(Q(i, j)); });
}

Matrix with_singular_values(int rows, int columns, const Vector& values, unsigned seed) {
  const Matrix Q = orthogonal_matrix(rows, seed), P = orthogonal_matrix(columns, seed + 1);
  return made(rows, columns, [&](int i, int j) {
    long double sum = 0.0L;
    for (int k = 0; k < static_cast<int>(values.size()); ++k) {
      sum += static_cast<long double>(values[k]) * Q(i, k) * P(j, k);
    }
    return static_cast<double>(sum);
  });
}

Matrix transposed(const Matrix& A) {
  return made(columns(A), rows(A), [&](int i, int j) { return A(j, i); });
}

Matrix product(const Matrix& A, const Matrix& B) {
  return made(rows(A), columns(B), [&](int i, int j) {
    long double sum = 0.0L;
    for (int k = 0; k < columns(A); ++k) sum += static_cast<long double>(A(i, k)) * B(k, j);
    return static_cast<double>(sum);
  });
}

Vector product(const Matrix& A, const Vector& b) {
  Vector result(rows(A));
  for (int i = 0; i < rows(A); ++i) {
    long double sum = 0.0L;
    for (int k = 0; k < columns(A); ++k) sum += static_cast<long double>(A(i, k)) * b[k];
    result[i] = static_cast<double>(sum);
  }
  return result;
}

Eigen::MatrixXcd complex_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  return made(rows(A), columns(B), [&](int i, int j) {
    long double real = 0.0L, imaginary = 0.0L;
    for (int k = 0; k < columns(A); ++k) {
      const long double a = A(i, k).real(), b = A(i, k).imag(), c = B(k, j).real(), d = B(k, j).imag();
      real += a * c - b * d;
      imaginary += a * d + b * c;
    }
    return std::complex<double>(static_cast<double>(real), static_cast<double>(imaginary));
  });
}

double largest(const Matrix& A) {
  return largest_difference(A, made(rows(A), columns(A), [](int, int) { return 0.0; }));
}

double distance(const Matrix& A, const Matrix& B) { return largest_difference(A, B); }

double complex_distance(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  return largest_difference(A, B);
}

double distance_from_orthonormal(const Matrix& A) {
  const int size = columns(A);
  return distance(product(transposed(A), A),
                  made(size, size, [](int i, int j) { return i == j ? 1.0 : 0.0; }));
}

double column_norm(const Matrix& A) {
  double result = 0.0;
  for (int j = 0; j < columns(A); ++j) {
    double sum = 0.0;
    for (int i = 0; i < rows(A); ++i) sum += std::abs(A(i, j));
    result = std::max(result, sum);
  }
  return result;
}

bool any_nan(const Matrix& A) { return std::isnan(largest(A)); }

bool any_complex_nan(const Eigen::MatrixXcd& A) {
  for (int j = 0; j < columns(A); ++j) {
    for (int i = 0; i < rows(A); ++i) {
      if (std::isnan(A(i, j).real()) || std::isnan(A(i, j).imag())) return true;
    }
  }
  return false;
}

}  // namespace signorini::test
