#pragma once

#include <Eigen/Core>
#include <optional>

namespace signorini {

/// The free motions of a damped structure, damping proportional or not:
///
///     q(t) = Re sum_k w_k shapes_k a_k e^{mu_k t},   a = left (q(0), q'(0)),
///
/// Im mu_k >= 0; w_k = 2 for a pair, 1 for a real mu_k.
struct ComplexModes {
  Eigen::VectorXcd mu;      ///< Nm [rad/s]
  Eigen::MatrixXcd shapes;  ///< Nr x Nm
  Eigen::MatrixXcd left;    ///< Nm x 2 Nr
  Eigen::VectorXd weight;   ///< w_k, Nm
};

/// The modes of M q'' + D q' + K q = 0, found in the coordinates of the energy (EnergyForm) and with long
/// double for up to 12 coordinates. None where they are ill-conditioned (critical damping, a rigid-body
/// motion: more than three digits would cancel between them) or M is not definite.
///
/// \param rate  that of the load [rad/s], > 0: the unit in which K counts as definite
std::optional<ComplexModes> complex_modes(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D,
                                          const Eigen::MatrixXd& K, double rate);

}  // namespace signorini
