#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
constexpr Eigen::Index kLongDouble = 12;  // coordinates up to which extended precision is cheap
// The factor by which digits may cancel between modes. Of the hundred vectors of a reduced structure one is
// often as near to critical damping as a thousandth, which costs that mode alone three digits, and
// exponentials a minute.
constexpr double kIllConditioned = 1e3, kIllConditionedOfMany = 1e4;
constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

double most_cancelled(Eigen::Index coordinates) {
  return coordinates > kLongDouble ? kIllConditionedOfMany : kIllConditioned;
}

ComplexModes modes_of_size(Eigen::Index count, Eigen::Index n) {
  return {.mu = Eigen::VectorXcd(count),
          .weight = Eigen::VectorXd(count),
          .shapes = Eigen::MatrixXcd(n, count),
          .left = Eigen::MatrixXcd(count, 2 * n),
          .of_load = Eigen::MatrixXcd(count, n)};
}

// The undamped modes phi_k of a structure whose damping couples none of them: z_k'' + d_k z_k' + l_k z_k = 0.
struct RealModes {
  Extended squares;       // l_k, n
  Extended damping;       // d_k, n
  ExtendedMatrix shapes;  // phi_k of z, orthonormal, n x n
};

// None where damping couples modes by more than D was rounded by, K~ is not symmetric and definite, or the
// l_k spread so far that the least of them would be lost in rounding.
std::optional<RealModes> real_modes(const MassForm& form) {
  constexpr long double kLost = 1e-15L;             // of the least l_k
  constexpr long double kRounded = 2.0 * kEpsilon;  // of D
  const Eigen::Index n = form.size();
  const auto lost = [n](long double largest) { return kRounding * static_cast<long double>(n) * largest; };
  // The l_k reach from below the least element of the diagonal to above the largest: most structures whose
  // l_k spread too far end here.
  const auto diagonal = form.stiffness.diagonal();
  if (!form.definite || lost(diagonal.maxCoeff()) > kLost * diagonal.minCoeff()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<ExtendedMatrix> solver(form.stiffness);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Extended& squares = solver.eigenvalues();
  const long double skew = (form.stiffness - form.stiffness.transpose()).norm();
  if (!(squares[0] > 0.0L && std::max(lost(squares[n - 1]), skew) <= kLost * squares[0])) return std::nullopt;
  const ExtendedMatrix damping = solver.eigenvectors().transpose() * form.damping * solver.eigenvectors();
  ExtendedMatrix coupling = damping;
  coupling.diagonal().setZero();
  if (!(coupling.norm() <= kRounded * damping.diagonal().cwiseAbs().maxCoeff())) return std::nullopt;
  return RealModes{.squares = squares, .damping = damping.diagonal(), .shapes = solver.eigenvectors()};
}

// mu^2 + d mu + l = 0 of each mode: a pair, or two real mu.
std::optional<ComplexModes> modes_of(const RealModes& real, const MassForm& form, double rate) {
  const Eigen::Index n = form.size();
  const Extended halved = 0.5L * real.damping;
  const Extended square_of_rate = real.squares - halved.cwiseProduct(halved);
  ComplexModes modes = modes_of_size(2 * n - (square_of_rate.array() > 0.0L).count(), n);
  const ExtendedMatrix shapes = form.q_of_z * real.shapes;
  const ExtendedMatrix of_q = real.shapes.transpose() * form.L.transpose();
  Eigen::Index place = 0;
  // With z_k = a + b, z_k' = mu a + other b: a = (z_k' - other z_k) / (mu - other).
  const auto add = [&](Eigen::Index k, std::complex<long double> mu, std::complex<long double> other) {
    const std::complex<long double> part = 1.0L / (mu - other);
    modes.mu[place] = static_cast<Complex>(mu);
    modes.weight[place] = mu.imag() > 0.0L ? 2.0 : 1.0;
    modes.shapes.col(place) = shapes.col(k).cast<Complex>();
    modes.left.row(place).head(n) = (-other * part * of_q.row(k)).template cast<Complex>();
    modes.left.row(place).tail(n) = (part * of_q.row(k)).template cast<Complex>();
    modes.of_load.row(place) = (part * shapes.col(k).transpose()).template cast<Complex>();
    ++place;
  };
  for (Eigen::Index k = 0; k < n; ++k) {
    const long double length = std::sqrt(std::abs(square_of_rate[k]));
    const bool pair = square_of_rate[k] > 0.0L;
    // Of two real mu that of the larger magnitude adds what the other one would subtract.
    const std::complex<long double> mu(-halved[k] - (pair ? 0.0L : std::copysign(length, halved[k])),
                                       pair ? length : 0.0L);
    const std::complex<long double> other = pair ? std::conj(mu) : real.squares[k] / mu;
    const long double energy = real.squares[k] + static_cast<long double>(rate) * rate;
    const long double condition =
        std::sqrt((energy + std::norm(mu)) * (energy + std::norm(other)) / energy) / std::abs(mu - other);
    if (!(condition < most_cancelled(n))) return std::nullopt;
    add(k, mu, other);
    if (!pair) add(k, other, mu);
  }
  return modes;
}

// Of any damping: the eigenvectors of B.
template <class Real>
std::optional<ComplexModes> modes_in(const MassForm& form, double rate) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;
  const EnergyForm energy(form, rate);
  if (!energy.definite) return std::nullopt;
  const Eigen::EigenSolver<Matrix> solver(energy.B.cast<Real>());
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::Index n = form.size();
  const auto in_precision = [](const ExtendedMatrix& A) {
    return ComplexMatrix(A.cast<std::complex<Real>>());
  };
  // Rows of V^-1 are the left vectors: amplitudes are V^-1 (e, z'), and (e, z') = (E^T L^T q, L^T q').
  const ComplexMatrix V = solver.eigenvectors();
  const ComplexMatrix inverse = V.partialPivLu().inverse();
  const ComplexMatrix shapes = in_precision(form.q_of_z * energy.z_of_e) * V.topRows(n);
  const ComplexMatrix of_q = inverse.leftCols(n) * in_precision(energy.E.transpose() * form.L.transpose());
  const ComplexMatrix of_rate = inverse.rightCols(n) * in_precision(form.L.transpose());
  const ComplexMatrix of_load = inverse.rightCols(n) * in_precision(form.q_of_z.transpose());
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    // |v_k| |w_k| with w_k v_k = 1 is the condition of the eigenvalue and bounds what cancels in its mode.
    const Real condition = V.col(k).norm() * inverse.row(k).norm();
    if (!(condition < static_cast<Real>(most_cancelled(n)))) return std::nullopt;
    if (solver.eigenvalues()[k].imag() >= Real(0)) kept.push_back(k);
  }
  ComplexModes modes = modes_of_size(static_cast<Eigen::Index>(kept.size()), n);
  for (Eigen::Index i = 0; i < modes.mu.size(); ++i) {
    const Eigen::Index k = kept[static_cast<std::size_t>(i)];
    modes.mu[i] = static_cast<Complex>(solver.eigenvalues()[k]);
    modes.weight[i] = modes.mu[i].imag() > 0.0 ? 2.0 : 1.0;
    modes.shapes.col(i) = shapes.col(k).template cast<Complex>();
    modes.left.row(i).head(n) = of_q.row(k).template cast<Complex>();
    modes.left.row(i).tail(n) = of_rate.row(k).template cast<Complex>();
    modes.of_load.row(i) = of_load.row(k).template cast<Complex>();
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
  return form.size() <= kLongDouble ? modes_in<long double>(form, rate) : modes_in<double>(form, rate);
}

}  // namespace signorini
