#include "methods/linear_flow/modes/complex_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/extended/eigenbasis.hpp"
#include "methods/solvers/extended/symmetric_eigenpairs.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/structure.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr long double kExtendedRounding = std::numeric_limits<long double>::epsilon();

long double skew_part(const ExtendedMatrix& A) {
  long double sum = 0.0L;
  for (Index j = 0; j < A.cols(); ++j)
    for (Index i = 0; i < j; ++i) sum += 2.0L * (A(i, j) - A(j, i)) * (A(i, j) - A(j, i));
  return std::sqrt(sum);
}

constexpr long double kLost = 1e-15L;  // of the least l_k

long double lost_of(long double largest, Index n) {
  return kExtendedRounding * static_cast<long double>(n) * largest;
}

// Whether the l_k spread so far that the least of them would be lost in rounding: they reach from below the
// least element of the diagonal to above the largest, at which most such structures are seen.
bool spread_far(const MassForm& form) {
  long double least = form.stiffness(0, 0), largest = least;
  for (Index j = 0; j < form.size(); ++j) {
    least = std::min(least, form.stiffness(j, j));
    largest = std::max(largest, form.stiffness(j, j));
  }
  return lost_of(largest, form.size()) > kLost * least;
}

// Those with D~ = alpha + beta K~ up to what D was rounded by; none of any other D~, or where K~ is diagonal.
std::optional<ProportionalDamping> proportional_damping(const MassForm& form) {
  constexpr long double kRounded = 8.0 * kEpsilon;  // of D, and of springs and dashpots in it
  const ExtendedMatrix &D = form.damping, &K = form.stiffness;
  Index row = 0, column = 0, softest = 0;
  long double beside = 0.0L, most = 0.0L;
  for (Index j = 0; j < form.size(); ++j) {
    if (K(j, j) < K(softest, softest)) softest = j;
    for (Index i = 0; i < form.size(); ++i) {
      most = std::max(most, std::abs(D(i, j)));
      if (i == j || std::abs(K(i, j)) <= beside) continue;
      beside = std::abs(K(i, j));
      row = i;
      column = j;
    }
  }
  if (beside == 0.0L) return std::nullopt;
  const long double beta = D(row, column) / K(row, column);
  const long double alpha = D(softest, softest) - beta * K(softest, softest);
  for (Index j = 0; j < form.size(); ++j) {
    for (Index i = 0; i < form.size(); ++i) {
      if (!(std::abs(D(i, j) - beta * K(i, j) - (i == j ? alpha : 0.0L)) <= kRounded * most))
        return std::nullopt;
    }
  }
  return ProportionalDamping{.alpha = static_cast<double>(alpha), .beta = static_cast<double>(beta)};
}

// None where a l_k is not positive.
std::optional<RealModes> real_modes(const MassForm& form) {
  if (!form.definite) return std::nullopt;
  auto pairs = extended::symmetric_eigenpairs(form.stiffness);
  if (!pairs || !(pairs->values.front() > 0.0L)) return std::nullopt;
  RealModes real{.squares = std::move(pairs->values),
                 .damping = {},
                 .shapes = std::move(pairs->vectors),
                 .coupling = {}};
  if (const auto factors = proportional_damping(form)) {
    for (const long double square : real.squares)
      real.damping.push_back(factors->alpha + factors->beta * square);
    real.coupling = ExtendedMatrix(form.size(), form.size());
    std::fill_n(real.coupling.data(), real.coupling.size(), 0.0L);
    return real;
  }
  real.coupling = extended::product(extended::transposed_product(real.shapes, form.damping), real.shapes);
  for (Index k = 0; k < form.size(); ++k) real.damping.push_back(std::exchange(real.coupling(k, k), 0.0L));
  return real;
}

// Whether K~ is symmetric, and the least l_k not lost: of few coordinates, of which other modes are as cheap.
bool exact(const RealModes& real, const MassForm& form) {
  const std::vector<long double>& squares = real.squares;
  return std::max(lost_of(squares.back(), form.size()), skew_part(form.stiffness)) <= kLost * squares.front();
}

bool symmetric(const ExtendedMatrix& A) {
  constexpr long double kSymmetric = 1e-12L;
  return skew_part(A) <= kSymmetric * extended::norm(A);
}

// Whether damping couples no modes by more than D was rounded by.
bool uncoupled(const RealModes& real) {
  constexpr long double kRounded = 2.0 * kEpsilon;  // of D
  long double most = 0.0L;
  for (const long double damping : real.damping) most = std::max(most, std::abs(damping));
  return extended::norm(real.coupling) <= kRounded * most;
}

// mu^2 + d mu + l = 0 of each mode: a pair, or two real mu.
std::optional<ComplexModes> modes_of(const RealModes& real, const MassForm& form, double rate) {
  using ExtendedComplex = std::complex<long double>;
  const Index n = form.size();
  const auto square_of_rate = [&real](std::size_t k) {
    const long double halved = 0.5L * real.damping[k];
    return real.squares[k] - halved * halved;
  };
  Index count = 2 * n;
  for (std::size_t k = 0; k < real.squares.size(); ++k) count -= square_of_rate(k) > 0.0L ? 1 : 0;
  ComplexModes modes = ComplexModes::of_size(count, n);
  const ExtendedMatrix shapes = form.unit ? real.shapes : extended::product(form.q_of_z, real.shapes),
                       q_of_shapes = form.unit ? real.shapes : extended::product(form.L, real.shapes);
  Index place = 0;
  // With z_k = a + b, z_k' = mu a + other b: a = (z_k' - other z_k) / (mu - other).
  const auto add = [&](Index k, ExtendedComplex mu, ExtendedComplex other) {
    const ExtendedComplex part = 1.0L / (mu - other), of_position = -other * part;
    modes.mu[place] = static_cast<Complex>(mu);
    modes.weight[place] = mu.imag() > 0.0L ? 2.0 : 1.0;
    for (Index i = 0; i < n; ++i) {
      modes.shapes(i, place) = static_cast<double>(shapes(i, k));
      modes.left(place, i) = static_cast<Complex>(of_position * q_of_shapes(i, k));
      modes.left(place, n + i) = static_cast<Complex>(part * q_of_shapes(i, k));
      modes.of_load(place, i) = static_cast<Complex>(part * shapes(i, k));
    }
    ++place;
  };
  for (Index k = 0; k < n; ++k) {
    const auto of_k = static_cast<std::size_t>(k);
    const long double square = square_of_rate(of_k), length = std::sqrt(std::abs(square));
    const long double halved = 0.5L * real.damping[of_k];
    const bool pair = square > 0.0L;
    // Of two real mu that of the larger magnitude adds what the other one would subtract.
    const ExtendedComplex mu(-halved - (pair ? 0.0L : std::copysign(length, halved)), pair ? length : 0.0L);
    const ExtendedComplex other = pair ? std::conj(mu) : real.squares[of_k] / mu;
    const long double energy = real.squares[of_k] + static_cast<long double>(rate) * rate;
    const long double condition =
        std::sqrt((energy + std::norm(mu)) * (energy + std::norm(other)) / energy) / std::abs(mu - other);
    if (!(condition < most_cancelled(n))) return std::nullopt;
    add(k, mu, other);
    if (!pair) add(k, other, mu);
  }
  return modes;
}

std::optional<ComplexModes> weakly_coupled_modes(const RealModes& real, const MassForm& form, double rate) {
  if (!symmetric(form.stiffness) || !symmetric(form.damping)) return std::nullopt;
  std::optional<ComplexModes> modes = weakly_coupled(real, rate);
  if (!modes) return std::nullopt;
  const Eigen::MatrixXd S = extended::rounded(extended::product(form.q_of_z, real.shapes)),
                        R = extended::rounded(extended::product(form.L, real.shapes));
  return in_coordinates(*std::move(modes), S, R);
}

// Of 2 Nr modes those with Im mu >= 0. Rows of all but the shapes are theirs.
ComplexModes upper_half(const Eigen::VectorXcd& mu, const Eigen::MatrixXcd& shapes,
                        const Eigen::MatrixXcd& of_q, const Eigen::MatrixXcd& of_rate,
                        const Eigen::MatrixXcd& of_load) {
  std::vector<Index> kept;
  for (Index k = 0; k < mu.size(); ++k)
    if (mu[k].imag() >= 0.0) kept.push_back(k);
  ComplexModes modes = ComplexModes::of_size(std::ssize(kept), shapes.rows());
  modes.mu = mu(kept);
  modes.shapes = shapes(Eigen::all, kept);
  modes.left << of_q(kept, Eigen::all), of_rate(kept, Eigen::all);
  modes.of_load = of_load(kept, Eigen::all);
  for (Index k = 0; k < modes.mu.size(); ++k) modes.weight[k] = modes.mu[k].imag() > 0.0 ? 2.0 : 1.0;
  return modes;
}

// Columns of right vectors, or of left ones, which are (row k - i row k+1) / 2 of a pair; zero where Im mu <
// 0.
Eigen::MatrixXcd unpacked(const extended::Eigenbasis& basis, const ExtendedMatrix& parts, bool left) {
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(parts.rows(), parts.cols());
  for (Index k = 0; k < parts.cols(); ++k) {
    const long double imaginary = basis.imaginary[static_cast<std::size_t>(k)];
    const bool pair = imaginary > 0.0L;
    const long double re = left && pair ? 0.5L : 1.0L, im = left ? -re : re;
    for (Index i = 0; i < parts.rows() && imaginary >= 0.0L; ++i)
      result(i, k) = Complex(static_cast<double>(re * parts(i, k)),
                             pair ? static_cast<double>(im * parts(i, k + 1)) : 0.0);
  }
  return result;
}

// Of any damping: the eigenvectors of B. Rows of V^-1 are the left vectors: amplitudes are V^-1 (e, z'), and
// (e, z') = (E^T L^T q, L^T q'). |v_k| |w_k| with w_k v_k = 1 is the condition of the eigenvalue and bounds
// what cancels in its mode.
std::optional<ComplexModes> modes_in_long_double(const MassForm& form, const EnergyForm& energy) {
  const auto basis = extended::eigenbasis(energy.B);
  if (!basis) return std::nullopt;
  const Index n = form.size();
  Eigen::VectorXcd mu(2 * n);
  // Column k of the vectors and row k of the inverse, of half the coordinates and in others.
  ExtendedMatrix positions(n, 2 * n), of_e(n, 2 * n), of_rate(n, 2 * n);
  for (Index k = 0; k < 2 * n; ++k) {
    mu[k] = Complex(static_cast<double>(basis->real[static_cast<std::size_t>(k)]),
                    static_cast<double>(basis->imaginary[static_cast<std::size_t>(k)]));
    for (Index i = 0; i < n; ++i) {
      positions(i, k) = basis->vectors(i, k);
      of_e(i, k) = basis->inverse(k, i);
      of_rate(i, k) = basis->inverse(k, n + i);
    }
  }
  for (Index k = 0; k < 2 * n; ++k) {
    if (mu[k].imag() < 0.0) continue;
    long double right = 0.0L, left = 0.0L;
    const Index places = mu[k].imag() > 0.0 ? 2 : 1;
    for (Index place = k; place < k + places; ++place) {
      for (Index i = 0; i < 2 * n; ++i) {
        right += basis->vectors(i, place) * basis->vectors(i, place);
        left += basis->inverse(place, i) * basis->inverse(place, i);
      }
    }
    const long double condition = std::sqrt(right * left) / static_cast<long double>(places);
    if (!(condition < most_cancelled(n))) return std::nullopt;
  }
  const auto left = [&](const ExtendedMatrix& A, const ExtendedMatrix& parts) {
    return Eigen::MatrixXcd(unpacked(*basis, extended::product(A, parts), true).transpose());
  };
  const ExtendedMatrix shapes = extended::product(extended::product(form.q_of_z, energy.z_of_e), positions);
  return upper_half(mu, unpacked(*basis, shapes, false), left(extended::product(form.L, energy.E), of_e),
                    left(form.L, of_rate), left(form.q_of_z, of_rate));
}

Eigen::MatrixXcd product_of(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) { return A * B; }

Eigen::MatrixXcd in_complex(const ExtendedMatrix& A) { return extended::rounded(A).cast<Complex>(); }

std::optional<ComplexModes> modes_in_double(const MassForm& form, const EnergyForm& energy) {
  const GeneralEigen pairs = general_eigen(extended::rounded(energy.B));
  if (!pairs.converged) return std::nullopt;
  const Index n = form.size();
  const Eigen::MatrixXcd &V = pairs.vectors, inverse = signorini::inverse(V);
  for (Index k = 0; k < 2 * n; ++k)
    if (!(V.col(k).norm() * inverse.row(k).norm() < most_cancelled(n))) return std::nullopt;
  const Eigen::MatrixXcd of_e = inverse.leftCols(n), of_z = inverse.rightCols(n);
  return upper_half(pairs.values,
                    product_of(in_complex(extended::product(form.q_of_z, energy.z_of_e)), V.topRows(n)),
                    product_of(of_e, in_complex(extended::transposed(extended::product(form.L, energy.E)))),
                    product_of(of_z, in_complex(extended::transposed(form.L))),
                    product_of(of_z, in_complex(extended::transposed(form.q_of_z))));
}

}  // namespace

std::optional<ComplexModes> complex_modes(const MassForm& form, double rate) {
  const bool small = form.size() <= kLongDouble;
  const bool far = form.size() == 0 || spread_far(form);
  if (!small || !far) {
    const std::optional<RealModes> real = real_modes(form);
    if (real && !far && exact(*real, form) && uncoupled(*real)) return modes_of(*real, form, rate);
    if (real && !small) {
      if (symmetric(form.stiffness) && uncoupled(*real)) {
        if (auto modes = modes_of(*real, form, rate)) return modes;
      }
      if (auto weak = weakly_coupled_modes(*real, form, rate)) return weak;
    }
  }
  const EnergyForm energy(form, rate);
  if (!energy.definite) return std::nullopt;
  return small ? modes_in_long_double(form, energy) : modes_in_double(form, energy);
}

}  // namespace signorini
