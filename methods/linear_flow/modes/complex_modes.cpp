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

namespace signorini {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr Index kLongDouble = 12;  // coordinates up to which extended precision is cheap
// The factor by which digits may cancel between modes. Of the hundred vectors of a reduced structure one is
// often as near to critical damping as a thousandth, which costs that mode alone three digits, and
// exponentials a minute.
constexpr double kIllConditioned = 1e3, kIllConditionedOfMany = 1e4;
constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

double most_cancelled(Index coordinates) {
  return coordinates > kLongDouble ? kIllConditionedOfMany : kIllConditioned;
}

ComplexModes modes_of_size(Index count, Index n) {
  return {.mu = Eigen::VectorXcd(count),
          .weight = Eigen::VectorXd(count),
          .shapes = Eigen::MatrixXcd(n, count),
          .left = Eigen::MatrixXcd(count, 2 * n),
          .of_load = Eigen::MatrixXcd(count, n)};
}

// The undamped modes phi_k of a structure whose damping couples none of them: z_k'' + d_k z_k' + l_k z_k = 0.
struct RealModes {
  std::vector<long double> squares;  // l_k, n
  std::vector<long double> damping;  // d_k, n
  ExtendedMatrix shapes;             // phi_k of z, orthonormal, n x n
};

// None where damping couples modes by more than D was rounded by, K~ is not symmetric and definite, or the
// l_k spread so far that the least of them would be lost in rounding.
std::optional<RealModes> real_modes(const MassForm& form) {
  constexpr long double kLost = 1e-15L;             // of the least l_k
  constexpr long double kRounded = 2.0 * kEpsilon;  // of D
  const Index n = form.size();
  const auto lost = [n](long double largest) { return kRounding * static_cast<long double>(n) * largest; };
  // The l_k reach from below the least element of the diagonal to above the largest: most structures whose
  // l_k spread too far end here.
  if (n == 0) return std::nullopt;
  long double least = form.stiffness(0, 0), largest = least, skew = 0.0L;
  for (Index j = 0; j < n; ++j) {
    least = std::min(least, form.stiffness(j, j));
    largest = std::max(largest, form.stiffness(j, j));
    for (Index i = 0; i < j; ++i) {
      const long double difference = form.stiffness(i, j) - form.stiffness(j, i);
      skew += 2.0L * difference * difference;
    }
  }
  if (!form.definite || lost(largest) > kLost * least) return std::nullopt;
  auto pairs = extended::symmetric_eigenpairs(form.stiffness);
  if (!pairs) return std::nullopt;
  const std::vector<long double>& squares = pairs->values;
  if (!(squares.front() > 0.0L && std::max(lost(squares.back()), std::sqrt(skew)) <= kLost * squares.front()))
    return std::nullopt;
  ExtendedMatrix coupling =
      extended::product(extended::transposed_product(pairs->vectors, form.damping), pairs->vectors);
  std::vector<long double> damping(squares.size());
  long double most = 0.0L;
  for (Index k = 0; k < n; ++k) {
    damping[static_cast<std::size_t>(k)] = std::exchange(coupling(k, k), 0.0L);
    most = std::max(most, std::abs(damping[static_cast<std::size_t>(k)]));
  }
  if (!(extended::norm(coupling) <= kRounded * most)) return std::nullopt;
  return RealModes{.squares = std::move(pairs->values),
                   .damping = std::move(damping),
                   .shapes = std::move(pairs->vectors)};
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
  ComplexModes modes = modes_of_size(count, n);
  const ExtendedMatrix shapes = extended::product(form.q_of_z, real.shapes),
                       q_of_shapes = extended::product(form.L, real.shapes);
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

// Of any damping: the eigenvectors of B. Rows of V^-1 are the left vectors: amplitudes are V^-1 (e, z'), and
// (e, z') = (E^T L^T q, L^T q'). |v_k| |w_k| with w_k v_k = 1 is the condition of the eigenvalue and bounds
// what cancels in its mode.
std::optional<ComplexModes> modes_in_long_double(const MassForm& form, const EnergyForm& energy) {
  const auto basis = extended::eigenbasis(energy.B);
  if (!basis) return std::nullopt;
  const Index n = form.size();
  // Column k of the vectors and row k of the inverse, of half the coordinates and in others.
  ExtendedMatrix positions(n, 2 * n), of_e(n, 2 * n), of_rate(n, 2 * n);
  for (Index k = 0; k < 2 * n; ++k) {
    for (Index i = 0; i < n; ++i) {
      positions(i, k) = basis->vectors(i, k);
      of_e(i, k) = basis->inverse(k, i);
      of_rate(i, k) = basis->inverse(k, n + i);
    }
  }
  const ExtendedMatrix shapes = extended::product(extended::product(form.q_of_z, energy.z_of_e), positions);
  const ExtendedMatrix left_of_q = extended::product(extended::product(form.L, energy.E), of_e);
  const ExtendedMatrix left_of_rate = extended::product(form.L, of_rate),
                       of_load = extended::product(form.q_of_z, of_rate);
  const auto imaginary = [&](Index k) { return basis->imaginary[static_cast<std::size_t>(k)]; };
  Index count = 0;
  for (Index k = 0; k < 2 * n; ++k) {
    if (imaginary(k) < 0.0L) continue;
    ++count;
    long double right = 0.0L, left = 0.0L;
    const Index places = imaginary(k) > 0.0L ? 2 : 1;
    for (Index place = k; place < k + places; ++place) {
      for (Index i = 0; i < 2 * n; ++i) {
        right += basis->vectors(i, place) * basis->vectors(i, place);
        left += basis->inverse(place, i) * basis->inverse(place, i);
      }
    }
    const long double condition = std::sqrt(right * left) / static_cast<long double>(places);
    if (!(condition < most_cancelled(n))) return std::nullopt;
  }
  ComplexModes modes = modes_of_size(count, n);
  for (Index k = 0, place = 0; place < count; ++k) {
    if (imaginary(k) < 0.0L) continue;
    const bool pair = imaginary(k) > 0.0L;
    const auto joined = [&](const ExtendedMatrix& parts, Index i, long double re, long double im) {
      return Complex(static_cast<double>(re * parts(i, k)),
                     pair ? static_cast<double>(im * parts(i, k + 1)) : 0.0);
    };
    // Of a pair the left vector is (row k - i row k+1) / 2.
    const long double half = pair ? 0.5L : 1.0L;
    modes.mu[place] = Complex(static_cast<double>(basis->real[static_cast<std::size_t>(k)]),
                              static_cast<double>(imaginary(k)));
    modes.weight[place] = modes.mu[place].imag() > 0.0 ? 2.0 : 1.0;
    for (Index i = 0; i < n; ++i) {
      modes.shapes(i, place) = joined(shapes, i, 1.0L, 1.0L);
      modes.left(place, i) = joined(left_of_q, i, half, -half);
      modes.left(place, n + i) = joined(left_of_rate, i, half, -half);
      modes.of_load(place, i) = joined(of_load, i, half, -half);
    }
    ++place;
  }
  return modes;
}

Eigen::MatrixXcd product_of(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) { return A * B; }

Eigen::MatrixXcd in_complex(const ExtendedMatrix& A) {
  Eigen::MatrixXcd result(A.rows(), A.cols());
  for (Index i = 0; i < A.size(); ++i) result.data()[i] = static_cast<double>(A.data()[i]);
  return result;
}

std::optional<ComplexModes> modes_in_double(const MassForm& form, const EnergyForm& energy) {
  const GeneralEigen pairs = general_eigen(extended::rounded(energy.B));
  if (!pairs.converged) return std::nullopt;
  const Index n = form.size();
  const Eigen::MatrixXcd &V = pairs.vectors, inverse = signorini::inverse(V);
  const Eigen::MatrixXcd of_z = inverse.rightCols(n);
  const Eigen::MatrixXcd shapes =
      product_of(in_complex(extended::product(form.q_of_z, energy.z_of_e)), V.topRows(n));
  const Eigen::MatrixXcd of_q =
      product_of(inverse.leftCols(n), in_complex(extended::transposed(extended::product(form.L, energy.E))));
  const Eigen::MatrixXcd of_rate = product_of(of_z, in_complex(extended::transposed(form.L)));
  const Eigen::MatrixXcd of_load = product_of(of_z, in_complex(extended::transposed(form.q_of_z)));
  std::vector<Index> kept;
  for (Index k = 0; k < 2 * n; ++k) {
    const double condition = V.col(k).norm() * inverse.row(k).norm();
    if (!(condition < most_cancelled(n))) return std::nullopt;
    if (pairs.values[k].imag() >= 0.0) kept.push_back(k);
  }
  ComplexModes modes = modes_of_size(static_cast<Index>(kept.size()), n);
  for (Index place = 0; place < modes.mu.size(); ++place) {
    const Index k = kept[static_cast<std::size_t>(place)];
    modes.mu[place] = pairs.values[k];
    modes.weight[place] = modes.mu[place].imag() > 0.0 ? 2.0 : 1.0;
    for (Index i = 0; i < n; ++i) {
      modes.shapes(i, place) = shapes(i, k);
      modes.left(place, i) = of_q(k, i);
      modes.left(place, n + i) = of_rate(k, i);
      modes.of_load(place, i) = of_load(k, i);
    }
  }
  return modes;
}

}  // namespace

Eigen::VectorXcd ComplexModes::forced(const Eigen::VectorXcd& load, double rate) const {
  // Each mode of a pair answers by itself: q = sum_k U_k (of_load_k f) / (i rate - mu_k), conjugates
  // included.
  const Complex i_rate(0.0, rate);
  const Eigen::VectorXcd direct = (of_load * load).array() / (i_rate - mu.array());
  const Eigen::VectorXcd mirrored =
      (weight.array() - 1.0) * (of_load.conjugate() * load).array() / (i_rate - mu.array().conjugate());
  return shapes * direct + shapes.conjugate() * mirrored;
}

std::optional<ComplexModes> complex_modes(const MassForm& form, double rate) {
  if (const auto real = real_modes(form)) return modes_of(*real, form, rate);
  const EnergyForm energy(form, rate);
  if (!energy.definite) return std::nullopt;
  return form.size() <= kLongDouble ? modes_in_long_double(form, energy) : modes_in_double(form, energy);
}

}  // namespace signorini
