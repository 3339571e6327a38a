#include "problems/assembly/damping.hpp"

#include <cmath>
#include <limits>

#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// A shift s [1/s^2] that makes K + s M definite: 0 if K is, else the mean of w^2.
double shift_to_definite(const SparseMatrix& mass, const SparseMatrix& stiffness) {
  if (is_definite(stiffness)) return 0.0;
  const double springs = stiffness.diagonal().sum();
  return springs > 0.0 ? springs / mass.diagonal().sum() : 1.0;
}

// Solved as M psi = mu (K + s M) psi, mu = 1 / (w^2 + s), psi^T (K + s M) psi = 1, which welcomes a singular
// M and is most accurate where modes matter most, at low frequency. Then phi = psi / sqrt(mu).
SparseMatrix modal_damping(const std::vector<double>& ratios, const SparseMatrix& mass,
                           const SparseMatrix& stiffness) {
  const double shift = shift_to_definite(mass, stiffness);
  const Eigen::MatrixXd B = Eigen::MatrixXd(stiffness) + shift * Eigen::MatrixXd(mass);
  const SymmetricEigen modes = generalised_eigen(Eigen::MatrixXd(mass), B);
  if (!modes.converged) throw std::invalid_argument("modal damping: no eigenvectors");
  const Eigen::VectorXd& mu = modes.values;  // rising: the last belongs to the lowest frequency
  const Eigen::Index size = mu.size();
  const double rounding = static_cast<double>(size) * std::numeric_limits<double>::epsilon();
  Eigen::VectorXd root = Eigen::VectorXd::Zero(size);  // sqrt(2 zeta w / mu)
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index column = size - 1 - i;
    const double elastic = 1.0 - shift * mu(column);  // w^2 / (w^2 + s)
    if (mu(column) <= rounding * mu(size - 1) || elastic <= rounding) continue;
    const double ratio = i < std::ssize(ratios) ? ratios[static_cast<std::size_t>(i)] : ratios.back();
    const double frequency = std::sqrt(elastic / mu(column));
    root(column) = std::sqrt(2.0 * ratio * frequency / mu(column));
  }
  const Eigen::MatrixXd factor = mass * modes.vectors * root.asDiagonal();
  const Eigen::MatrixXd D = factor * factor.transpose();
  return (0.5 * (D + D.transpose())).sparseView();
}

}  // namespace

SparseMatrix damping_matrix(const DampingModel& model, const SparseMatrix& mass,
                            const SparseMatrix& stiffness) {
  if (const auto* rayleigh = std::get_if<ProportionalDamping>(&model)) {
    return combination(*rayleigh, mass, stiffness);
  }
  if (mass.rows() > kMostModalCoordinates) {
    throw std::invalid_argument("modal damping: too many coordinates");
  }
  return modal_damping(std::get<ModalDamping>(model).ratios, mass, stiffness);
}

}  // namespace signorini
