#include "methods/solvers/extended/symmetric_eigenpairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "methods/solvers/extended/reflections.hpp"

namespace signorini::extended {

namespace {

using Eigen::Index;

struct Tridiagonal {
  Numbers diagonal, beside;  // n and, with a zero at its end, n
};

// p = A u over the last `size` coordinates of a symmetric A, by its lower triangle, two columns at a time.
void multiply_symmetric(const ExtendedMatrix& A, const long double* u, long double* p, Index size) {
  const Index begin = A.rows() - size;
  std::fill_n(p, size, 0.0L);
  Index j = 0;
  for (; j + 1 < size; j += 2) {
    const long double *a = &A(begin, begin + j), *b = &A(begin, begin + j + 1);
    const long double u_a = u[j], u_b = u[j + 1];
    long double sum_a = a[j] * u_a + a[j + 1] * u_b, sum_b = a[j + 1] * u_a + b[j + 1] * u_b;
    for (Index i = j + 2; i < size; ++i) {
      const long double u_i = u[i], a_i = a[i], b_i = b[i];
      sum_a += a_i * u_i;
      sum_b += b_i * u_i;
      p[i] += a_i * u_a + b_i * u_b;
    }
    p[j] += sum_a;
    p[j + 1] += sum_b;
  }
  if (j < size) p[j] += A(begin + j, begin + j) * u[j];
}

// Q^T A Q; A keeps the u of the reflections that make up Q.
Tridiagonal tridiagonalise(ExtendedMatrix& A) {
  const Index n = A.rows();
  Tridiagonal T{.diagonal = Numbers(at(n)), .beside = Numbers(at(n))};
  Numbers products(at(n));
  for (Index k = 0; k + 2 < n; ++k) {
    const Index size = n - k - 1, begin = k + 1;
    long double* u = &A(begin, k);
    T.beside[at(k)] = reflect(u, size);
    // (I - u u^T) A (I - u u^T) = A - u w^T - w u^T,   w = A u - (u^T A u / 2) u
    long double* w = products.data();
    multiply_symmetric(A, u, w, size);
    const long double half = 0.5L * std::inner_product(u, u + size, w, 0.0L);
    for (Index i = 0; i < size; ++i) w[i] -= half * u[i];
    for (Index j = 0; j < size; ++j) {
      long double* a = &A(begin, begin + j);
      const long double u_j = u[j], w_j = w[j];
      for (Index i = j; i < size; ++i) a[i] -= u[i] * w_j + w[i] * u_j;
    }
  }
  for (Index k = 0; k < n; ++k) T.diagonal[at(k)] = A(k, k);
  if (n > 1) T.beside[at(n - 2)] = A(n - 1, n - 2);
  return T;
}

struct Rotation {
  long double c, s;
};

// A QR step on rows first..last of T with Wilkinson's shift: T <- G^T T G, G the product of the rotations of
// neighbours.
void step(Tridiagonal& T, Index first, Index last, std::vector<Rotation>& rotations) {
  Numbers &d = T.diagonal, &e = T.beside;
  const long double half = 0.5L * (d[at(last - 1)] - d[at(last)]), end = e[at(last - 1)];
  const long double shift =
      d[at(last)] - end * end / (half + std::copysign(std::sqrt(half * half + end * end), half));
  long double x = d[at(first)] - shift, z = e[at(first)];
  for (Index k = first; k < last; ++k) {
    const long double length = std::sqrt(x * x + z * z);
    const Rotation turn = length > 0.0L ? Rotation{x / length, z / length} : Rotation{1.0L, 0.0L};
    const auto [c, s] = turn;
    rotations[at(k)] = turn;
    if (k > first) e[at(k - 1)] = length;
    const long double difference = d[at(k)] - d[at(k + 1)], b = e[at(k)];
    const long double moved = s * (s * difference - 2.0L * c * b);
    d[at(k)] -= moved;
    d[at(k + 1)] += moved;
    e[at(k)] = c * (c * b - s * difference) - s * s * b;
    x = e[at(k)];
    if (k + 1 < last) {
      z = s * e[at(k + 1)];
      e[at(k + 1)] *= c;
    }
  }
}

// Q <- Q G of the rotations first..last - 1, Q by its transpose. Along a row of Q each entry is loaded and
// stored once for all of them; two rows share the loads of the rotations.
void rotate_rows(ExtendedMatrix& transposed_Q, Index first, Index last,
                 const std::vector<Rotation>& rotations) {
  const Index n = transposed_Q.rows();
  for (Index row = 0; row < n; row += 2) {
    long double* q = transposed_Q.data() + row * n;
    const bool pair = row + 1 < n;
    long double* next = pair ? q + n : q;
    long double a = q[first], b = next[first];
    for (Index k = first; k < last; ++k) {
      const auto [c, s] = rotations[at(k)];
      const long double a_k = q[k + 1], b_k = next[k + 1];
      q[k] = c * a + s * a_k;
      next[k] = c * b + s * b_k;
      a = c * a_k - s * a;
      b = c * b_k - s * b;
    }
    q[last] = a;
    next[last] = b;
  }
}

// Makes T diagonal; false where that takes too long.
bool diagonalise(Tridiagonal& T, ExtendedMatrix& transposed_Q) {
  const Index n = transposed_Q.rows();
  Numbers &d = T.diagonal, &e = T.beside;
  long double norm = 0.0L;
  for (Index k = 0; k < n; ++k) norm = std::max({norm, std::abs(d[at(k)]), std::abs(e[at(k)])});
  const auto couples = [&](Index k) {
    return !negligible(e[at(k)], std::abs(d[at(k)]) + std::abs(d[at(k + 1)]), norm);
  };
  std::vector<Rotation> rotations(at(n));
  Index last = n - 1;
  for (Index steps = 0; last > 0; ++steps) {
    if (!couples(last - 1)) {
      --last;
      continue;
    }
    if (steps > 40 * n) return false;
    Index first = last - 1;
    while (first > 0 && couples(first - 1)) --first;
    step(T, first, last, rotations);
    rotate_rows(transposed_Q, first, last, rotations);
  }
  return true;
}

}  // namespace

std::optional<SymmetricEigenpairs> symmetric_eigenpairs(const ExtendedMatrix& A) {
  if (!all_finite(A)) return std::nullopt;
  const Index n = A.rows();
  ExtendedMatrix reflections = A;
  Tridiagonal T = tridiagonalise(reflections);
  ExtendedMatrix rows = transposed(product_of_reflections(reflections));
  if (!diagonalise(T, rows)) return std::nullopt;
  std::vector<Index> order(at(n));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return T.diagonal[at(a)] < T.diagonal[at(b)]; });
  SymmetricEigenpairs pairs{.values = Numbers(at(n)), .vectors = ExtendedMatrix(n, n)};
  for (Index k = 0; k < n; ++k) {
    const Index from = order[at(k)];
    pairs.values[at(k)] = T.diagonal[at(from)];
    for (Index i = 0; i < n; ++i) pairs.vectors(i, k) = rows(from, i);
  }
  return pairs;
}

}  // namespace signorini::extended
