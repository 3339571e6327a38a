#include "methods/solvers/extended/reflections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::extended {

using Eigen::Index;

bool all_finite(const ExtendedMatrix& A) {
  return std::all_of(A.data(), A.data() + A.size(), [](long double a) { return std::isfinite(a); });
}

bool negligible(long double entry, long double neighbours, long double norm) {
  constexpr long double kEpsilon = std::numeric_limits<long double>::epsilon();
  return std::abs(entry) <= kEpsilon * std::max(neighbours, kEpsilon * norm);
}

long double reflect(long double* x, Index size) {
  long double below = 0.0L;
  for (Index i = 1; i < size; ++i) below += x[i] * x[i];
  const long double first = x[0];
  if (!(below > 0.0L)) {
    std::fill_n(x, size, 0.0L);
    return first;
  }
  // The sign that adds, and u = v / sqrt(|v|^2 / 2) for v = x - result e_1: |v|^2 = -2 result v_1.
  const long double result = -std::copysign(std::sqrt(first * first + below), first);
  x[0] = first - result;
  const long double scale = 1.0L / std::sqrt(-result * x[0]);
  for (Index i = 0; i < size; ++i) x[i] *= scale;
  return result;
}

void apply_reflection(const long double* u, long double* x, Index size) {
  long double sum = 0.0L;
  for (Index i = 0; i < size; ++i) sum += u[i] * x[i];
  for (Index i = 0; i < size; ++i) x[i] -= sum * u[i];
}

ExtendedMatrix product_of_reflections(const ExtendedMatrix& A) {
  const Index n = A.rows();
  ExtendedMatrix Q = identity(n);
  for (Index k = n - 3; k >= 0; --k) {
    for (Index j = k + 1; j < n; ++j) apply_reflection(&A(k + 1, k), &Q(k + 1, j), n - k - 1);
  }
  return Q;
}

}  // namespace signorini::extended
