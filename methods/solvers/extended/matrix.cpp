#include "methods/solvers/extended/matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::extended {

using Eigen::Index;

ExtendedMatrix widened(const Eigen::MatrixXd& A) {
  ExtendedMatrix wide(A.rows(), A.cols());
  for (Index i = 0; i < A.size(); ++i) wide.data()[i] = A.data()[i];
  return wide;
}

Eigen::MatrixXd rounded(const ExtendedMatrix& A) {
  Eigen::MatrixXd narrow(A.rows(), A.cols());
  for (Index i = 0; i < A.size(); ++i) narrow.data()[i] = static_cast<double>(A.data()[i]);
  return narrow;
}

bool all_finite(const ExtendedMatrix& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](long double a) { return std::isfinite(a); });
}

ExtendedMatrix identity(Index n) {
  ExtendedMatrix I(n, n);
  std::fill_n(I.data(), I.size(), 0.0L);
  for (Index i = 0; i < n; ++i) I(i, i) = 1.0L;
  return I;
}

ExtendedMatrix transposed(const ExtendedMatrix& A) {
  ExtendedMatrix turned(A.cols(), A.rows());
  for (Index j = 0; j < A.cols(); ++j) {
    for (Index i = 0; i < A.rows(); ++i) turned(j, i) = A(i, j);
  }
  return turned;
}

long double norm(const ExtendedMatrix& A) {
  long double sum = 0.0L;
  for (Index i = 0; i < A.size(); ++i) sum += A.data()[i] * A.data()[i];
  return std::sqrt(sum);
}

ExtendedMatrix product(const ExtendedMatrix& A, const ExtendedMatrix& B) {
  return transposed_product(transposed(A), B);
}

ExtendedMatrix transposed_product(const ExtendedMatrix& A, const ExtendedMatrix& B) {
  const Index depth = A.rows(), rows = A.cols(), columns = B.cols();
  ExtendedMatrix C(rows, columns);
  // Loads and stores of 80 bits are dearer than the arithmetic: four sums share their factors, and nothing is
  // stored before its end. The last of an odd number is computed twice.
  for (Index j = 0; j < columns; j += 2) {
    const Index next_j = std::min(j + 1, columns - 1);
    const long double *b = B.data() + j * depth, *next_b = B.data() + next_j * depth;
    for (Index i = 0; i < rows; i += 2) {
      const Index next_i = std::min(i + 1, rows - 1);
      const long double *a = A.data() + i * depth, *next_a = A.data() + next_i * depth;
      long double first = 0.0L, below = 0.0L, beside = 0.0L, across = 0.0L;
      for (Index k = 0; k < depth; ++k) {
        const long double a_k = a[k], next_a_k = next_a[k];
        first += a_k * b[k];
        below += next_a_k * b[k];
        beside += a_k * next_b[k];
        across += next_a_k * next_b[k];
      }
      C(i, j) = first;
      C(next_i, j) = below;
      C(i, next_j) = beside;
      C(next_i, next_j) = across;
    }
  }
  return C;
}

Cholesky cholesky(const ExtendedMatrix& A) {
  const Index n = A.rows();
  // The rows of L are the columns of R.
  ExtendedMatrix R = transposed(A);
  const auto remainder = [&R](Index i, Index j) {
    const long double *row = R.data() + i * R.rows(), *other = R.data() + j * R.rows();
    long double sum = row[j];
    for (Index k = 0; k < j; ++k) sum -= row[k] * other[k];
    return sum;
  };
  bool definite = true;
  for (Index j = 0; j < n && definite; ++j) {
    const long double pivot = remainder(j, j);
    definite = pivot > 0.0L;
    if (!definite) break;
    R(j, j) = std::sqrt(pivot);
    for (Index i = j + 1; i < n; ++i) R(j, i) = remainder(i, j) / R(j, j);
  }
  ExtendedMatrix L = transposed(R);
  for (Index j = 1; j < n; ++j) std::fill_n(L.data() + j * n, j, 0.0L);
  return {.definite = definite, .L = std::move(L)};
}

ExtendedMatrix solve_lower(const ExtendedMatrix& L, const ExtendedMatrix& B) {
  const Index n = L.rows();
  const ExtendedMatrix R = transposed(L);
  ExtendedMatrix X = B;
  // Two columns share the loads of L; what is zero at their heads stays so.
  for (Index j = 0; j < X.cols(); j += 2) {
    long double* x = X.data() + j * n;
    long double* next = X.data() + std::min(j + 1, X.cols() - 1) * n;
    Index begin = 0;
    while (begin < n && x[begin] == 0.0L && next[begin] == 0.0L) ++begin;
    for (Index i = begin; i < n; ++i) {
      const long double* row = R.data() + i * n;
      long double sum = x[i], next_sum = next[i];
      for (Index k = begin; k < i; ++k) {
        const long double factor = row[k];
        sum -= factor * x[k];
        next_sum -= factor * next[k];
      }
      x[i] = sum / row[i];
      next[i] = next_sum / row[i];
    }
  }
  return X;
}

std::optional<ExtendedMatrix> inverse(const ExtendedMatrix& A) {
  const Index n = A.rows();
  ExtendedMatrix U = A, X = identity(n);
  const auto subtract = [n](long double factor, const long double* from, long double* to, Index begin) {
    for (Index i = begin; i < n; ++i) to[i] -= factor * from[i];
  };
  for (Index k = 0; k < n; ++k) {
    long double* column = U.data() + k * n;
    const long double* largest = std::max_element(
        column + k, column + n, [](long double a, long double b) { return std::abs(a) < std::abs(b); });
    if (!(std::abs(*largest) > 0.0L)) return std::nullopt;
    const Index pivot = largest - column;
    for (Index j = 0; j < n && pivot != k; ++j) {
      std::swap(U(k, j), U(pivot, j));
      std::swap(X(k, j), X(pivot, j));
    }
    for (Index i = k + 1; i < n; ++i) column[i] /= column[k];
    for (Index j = k + 1; j < n; ++j) subtract(U(k, j), column, U.data() + j * n, k + 1);
  }
  for (Index j = 0; j < n; ++j) {
    long double* x = X.data() + j * n;
    for (Index k = 0; k < n; ++k) {
      if (x[k] != 0.0L) subtract(x[k], U.data() + k * n, x, k + 1);
    }
    for (Index k = n - 1; k >= 0; --k) {
      x[k] /= U(k, k);
      for (Index i = 0; i < k; ++i) x[i] -= x[k] * U(i, k);
    }
  }
  return X;
}

}  // namespace signorini::extended
