#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <complex>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
constexpr Eigen::Index kLongDouble = 12;  // coordinates up to which extended precision is cheap
// The factor by which digits may cancel between modes. Of the hundred vectors of a reduced structure one is
// often as near to critical damping as a thousandth, which costs that mode alone three digits, and
// exponentials a minute.
constexpr double kIllConditioned = 1e3, kIllConditionedOfMany = 1e4;

template <class Real>
std::optional<ComplexModes> modes_in(const EnergyForm& form) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using ComplexMatrix = Eigen::Matrix<std::complex<Real>, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::EigenSolver<Matrix> solver(form.B.cast<Real>());
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::Index n = form.size();
  const auto in_precision = [](const ExtendedMatrix& A) {
    return ComplexMatrix(A.cast<std::complex<Real>>());
  };
  // Rows of V^-1 are the left vectors: amplitudes are V^-1 (e, z'), and (e, z') = (E^T L^T q, L^T q').
  const ComplexMatrix V = solver.eigenvectors();
  const ComplexMatrix inverse = V.partialPivLu().inverse();
  const ComplexMatrix shapes = in_precision(form.q_of_z * form.z_of_e) * V.topRows(n);
  const ComplexMatrix of_q = inverse.leftCols(n) * in_precision(form.E.transpose() * form.L.transpose());
  const ComplexMatrix of_rate = inverse.rightCols(n) * in_precision(form.L.transpose());
  const ComplexMatrix of_load = inverse.rightCols(n) * in_precision(form.q_of_z.transpose());
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    // |v_k| |w_k| with w_k v_k = 1 is the condition of the eigenvalue and bounds what cancels in its mode.
    const Real condition = V.col(k).norm() * inverse.row(k).norm();
    if (!(condition < static_cast<Real>(n > kLongDouble ? kIllConditionedOfMany : kIllConditioned)))
      return std::nullopt;
    if (solver.eigenvalues()[k].imag() >= Real(0)) kept.push_back(k);
  }
  const auto count = static_cast<Eigen::Index>(kept.size());
  ComplexModes modes{.mu = Eigen::VectorXcd(count),
                     .weight = Eigen::VectorXd(count),
                     .shapes = Eigen::MatrixXcd(n, count),
                     .left = Eigen::MatrixXcd(count, 2 * n),
                     .of_load = Eigen::MatrixXcd(count, n)};
  for (Eigen::Index i = 0; i < count; ++i) {
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

std::optional<ComplexModes> complex_modes(const EnergyForm& form) {
  if (!form.definite) return std::nullopt;
  return form.size() <= kLongDouble ? modes_in<long double>(form) : modes_in<double>(form);
}

}  // namespace signorini
