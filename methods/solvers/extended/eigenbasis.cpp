#include "methods/solvers/extended/eigenbasis.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

#include "methods/solvers/extended/reflections.hpp"

namespace signorini::extended {

namespace {

using Eigen::Index;
using Complex = std::complex<long double>;
using Limits = std::numeric_limits<long double>;

// A = Z T Z^T, Z orthogonal, T upper triangular but for blocks of two on its diagonal, each of a pair.
struct Schur {
  ExtendedMatrix T, Z;
};

// T <- H T H and Z <- Z H for H = I - u u^T of rows k..k + size - 1; columns of T before `left` and rows
// after `bottom` hold only zeros there.
template <int size>
void reflect_similar(Schur& schur, const long double* u, Index k, Index left, Index bottom) {
  const Index n = schur.T.rows();
  for (Index j = left; j < n; ++j) {
    long double* x = &schur.T(k, j);
    long double sum = 0.0L;
    for (int i = 0; i < size; ++i) sum += u[i] * x[i];
    for (int i = 0; i < size; ++i) x[i] -= sum * u[i];
  }
  const auto from_right = [&](long double* x, Index rows) {
    for (long double* const end = x + rows; x != end; ++x) {
      long double sum = 0.0L;
      for (int i = 0; i < size; ++i) sum += u[i] * x[i * n];
      for (int i = 0; i < size; ++i) x[i * n] -= sum * u[i];
    }
  };
  from_right(schur.T.data() + k * n, bottom + 1);
  from_right(schur.Z.data() + k * n, n);
}

Schur hessenberg_form(ExtendedMatrix A) {
  const Index n = A.rows();
  Numbers below(at(n)), products(at(n));
  for (Index k = 0; k + 2 < n; ++k) {
    const Index size = n - k - 1;
    long double* u = &A(k + 1, k);
    below[at(k)] = reflect(u, size);
    for (Index j = k + 1; j < n; ++j) apply_reflection(u, &A(k + 1, j), size);
    std::fill(products.begin(), products.end(), 0.0L);
    for (Index j = 0; j < size; ++j) {
      const long double* a = A.data() + (k + 1 + j) * n;
      for (Index i = 0; i < n; ++i) products[at(i)] += u[j] * a[i];
    }
    for (Index j = 0; j < size; ++j) {
      long double* a = A.data() + (k + 1 + j) * n;
      for (Index i = 0; i < n; ++i) a[i] -= products[at(i)] * u[j];
    }
  }
  Schur form{.T = {}, .Z = product_of_reflections(A)};
  for (Index k = 0; k + 2 < n; ++k) {
    A(k + 1, k) = below[at(k)];
    std::fill(&A(k + 1, k) + 1, A.data() + (k + 1) * n, 0.0L);
  }
  form.T = std::move(A);
  return form;
}

// The numbers a + b and a b of two shifts a and b, as diagonal (p, q) and product of the other two entries of
// a matrix of which they are the eigenvalues.
struct Shifts {
  long double p, q, beside;
};

Shifts shifts_of(const ExtendedMatrix& T, Index last, int steps) {
  // Shifts out of turn leave a circle of steps, as in a permutation, which the usual ones map to itself.
  constexpr int kOutOfTurn = 10;
  const long double end = T(last, last);
  if (steps % kOutOfTurn == 0 && steps > 0) {
    const long double beyond = end + std::abs(T(last, last - 1)) + 0.5L * std::abs(T(last - 1, last - 2));
    return {.p = beyond, .q = beyond, .beside = 0.0L};
  }
  return {.p = T(last - 1, last - 1), .q = end, .beside = T(last - 1, last) * T(last, last - 1)};
}

// Francis' step on rows first..last, at least three: the first column of (T - a)(T - b) determines a
// reflection, and those that bring T back to Hessenberg form make it a QR step with both shifts.
void step(Schur& schur, Index first, Index last, const Shifts& shifts) {
  ExtendedMatrix& T = schur.T;
  const Index k = first;
  // ((T - a)(T - b))_j,first / T_first+1,first
  long double u[3] = {
      ((T(k, k) - shifts.p) * (T(k, k) - shifts.q) - shifts.beside) / T(k + 1, k) + T(k, k + 1),
      (T(k, k) - shifts.p) + (T(k + 1, k + 1) - shifts.q), T(k + 2, k + 1)};
  for (Index row = first; row < last; ++row) {
    const int size = row + 1 < last ? 3 : 2;
    if (row > first) {
      long double* column = &T(row, row - 1);
      std::copy_n(column, size, u);
      column[0] = reflect(u, size);
      std::fill_n(column + 1, size - 1, 0.0L);
    } else {
      reflect(u, size);
    }
    if (size == 3) {
      reflect_similar<3>(schur, u, row, row, std::min(row + 3, last));
    } else {
      reflect_similar<2>(schur, u, row, row, last);
    }
  }
}

// Makes the block of rows k and k + 1 triangular if its eigenvalues are real.
void split(Schur& schur, Index k) {
  ExtendedMatrix& T = schur.T;
  const long double half = 0.5L * (T(k, k) - T(k + 1, k + 1)), c = T(k + 1, k);
  const long double square = half * half + T(k, k + 1) * c;
  if (square < 0.0L) return;
  // (w, c) is the vector of the value T_k+1,k+1 + w, w^2 - 2 half w - T_k,k+1 c = 0, which is not a
  // difference.
  long double u[2] = {half + std::copysign(std::sqrt(square), half), c};
  reflect(u, 2);
  reflect_similar<2>(schur, u, k, k, k + 1);
  T(k + 1, k) = 0.0L;
}

std::optional<Schur> schur_form(const ExtendedMatrix& A) {
  Schur schur = hessenberg_form(A);
  ExtendedMatrix& T = schur.T;
  const Index n = A.rows();
  const long double whole = norm(A);
  const auto couples = [&](Index k) {
    if (!negligible(T(k + 1, k), std::abs(T(k, k)) + std::abs(T(k + 1, k + 1)), whole)) return true;
    T(k + 1, k) = 0.0L;
    return false;
  };
  Index last = n - 1, all_steps = 0;
  int steps = 0;  // on the same last row
  while (last > 0) {
    Index first = last;
    while (first > 0 && couples(first - 1)) --first;
    if (first + 1 < last) {
      if (all_steps++ > 30 * n) return std::nullopt;
      step(schur, first, last, shifts_of(T, last, steps++));
      continue;
    }
    if (first < last) split(schur, first);
    last = first - 1;
    steps = 0;
  }
  return schur;
}

// The vectors of the eigenvalue of a block that ends with row `last`, in the basis of T, from its end on.
class BackSubstitution {
 public:
  explicit BackSubstitution(const ExtendedMatrix& T)
      : T_(T),
        rows_(transposed(T)),
        least_(std::max(Limits::epsilon() * norm(T), Limits::min())),
        re_(at(T.rows())),
        im_(at(T.rows())) {}

  // Whether rows k - 1 and k are a block.
  [[nodiscard]] bool pair(Index k) const { return k > 0 && T_(k, k - 1) != 0.0L; }

  // Writes the real part of the vector to one column and, if there is one, the imaginary part to the next.
  void solve(Index last, Complex mu, ExtendedMatrix& vectors) {
    Index k = last;
    std::fill(re_.begin(), re_.end(), 0.0L);
    std::fill(im_.begin(), im_.end(), 0.0L);
    if (pair(last)) {
      // Of the two rows of the block that with the larger entry beside the diagonal.
      const long double b = T_(last - 1, last), c = T_(last, last - 1);
      const bool upper = std::abs(b) > std::abs(c);
      set(last - 1, upper ? Complex(b) : mu - T_(last, last));
      set(last, upper ? mu - T_(last - 1, last - 1) : Complex(c));
      k -= 2;
    } else {
      set(last, 1.0L);
      k -= 1;
    }
    while (k >= 0) k -= eliminate(k, last, mu);
    const Index column = last - (pair(last) ? 1 : 0);
    std::copy(re_.begin(), re_.end(), &vectors(0, column));
    if (pair(last)) std::copy(im_.begin(), im_.end(), &vectors(0, last));
  }

 private:
  void set(Index k, Complex value) {
    re_[at(k)] = value.real();
    im_[at(k)] = value.imag();
  }

  // -sum_j T_kj x_j over `begin`..`end`
  [[nodiscard]] Complex remainder(Index k, Index begin, Index end) const {
    const long double* row = rows_.data() + k * rows_.rows();
    long double re = 0.0L, im = 0.0L;
    for (Index j = begin; j <= end; ++j) {
      re -= row[j] * re_[at(j)];
      im -= row[j] * im_[at(j)];
    }
    return {re, im};
  }

  // A divisor that may vanish: where a block before has the same eigenvalue, one of A within rounding has
  // not.
  [[nodiscard]] Complex regular(Complex a) const { return std::abs(a) < least_ ? Complex(least_) : a; }

  // Solves the block that ends with row k for its entries of the vector; the number of its rows.
  Index eliminate(Index k, Index last, Complex mu) {
    const Complex end = T_(k, k) - mu;
    if (!pair(k)) {
      set(k, remainder(k, k + 1, last) / regular(end));
      return 1;
    }
    // With a pivot: where the block is singular too, what it cannot balance stays as small as the rounding.
    const Complex first = T_(k - 1, k - 1) - mu, above = T_(k - 1, k), below = T_(k, k - 1);
    const Complex of_first = remainder(k - 1, k + 1, last), of_end = remainder(k, k + 1, last);
    const bool keep = std::abs(first) >= std::abs(below);
    const Complex pivot = keep ? first : below, beside = keep ? above : end, rest = keep ? of_first : of_end;
    const Complex factor = (keep ? below : first) / pivot;
    const Complex x =
        ((keep ? of_end : of_first) - factor * rest) / regular((keep ? end : above) - factor * beside);
    set(k, x);
    set(k - 1, (rest - beside * x) / pivot);
    return 2;
  }

  const ExtendedMatrix &T_, rows_;
  long double least_;
  Numbers re_, im_;
};

}  // namespace

std::optional<Eigenbasis> eigenbasis(const ExtendedMatrix& A) {
  if (!all_finite(A)) return std::nullopt;
  const Index n = A.rows();
  const auto schur = schur_form(A);
  if (!schur) return std::nullopt;
  const ExtendedMatrix& T = schur->T;
  Eigenbasis basis{.real = Numbers(at(n)), .imaginary = Numbers(at(n)), .vectors = {}, .inverse = {}};
  ExtendedMatrix of_T(n, n);
  BackSubstitution substitution(T);
  for (Index k = 0; k < n; ++k) {
    const bool pair = substitution.pair(k + 1 < n ? k + 1 : 0);
    const Index last = k + (pair ? 1 : 0);
    const long double half = 0.5L * (T(k, k) - T(last, last));
    const long double re = T(last, last) + half;
    const long double im = pair ? std::sqrt(-T(k, last) * T(last, k) - half * half) : 0.0L;
    for (Index i = k; i <= last; ++i) basis.real[at(i)] = re;
    basis.imaginary[at(k)] = im;
    if (pair) basis.imaginary[at(last)] = -im;
    substitution.solve(last, {re, im}, of_T);
    k = last;
  }
  basis.vectors = product(schur->Z, of_T);
  for (Index k = 0; k < n; ++k) {
    const Index last = k + (basis.imaginary[at(k)] > 0.0L ? 1 : 0);
    long double *begin = &basis.vectors(0, k), *end = basis.vectors.data() + (last + 1) * n;
    const long double length = std::sqrt(std::inner_product(begin, end, begin, 0.0L));
    std::for_each(begin, end, [length](long double& x) { x /= length; });
    k = last;
  }
  auto inverted = inverse(basis.vectors);
  if (!inverted) return std::nullopt;
  basis.inverse = std::move(*inverted);
  return basis;
}

}  // namespace signorini::extended
