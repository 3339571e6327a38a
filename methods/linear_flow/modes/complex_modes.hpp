#pragma once
// The free motions of a damped structure as a sum of exponentials.

#include <Eigen/Core>
#include <optional>

#include "methods/linear_flow/modes/energy_form.hpp"

namespace signorini {

/// The motions of a damped structure M q'' + D q' + K q = f, damping proportional or not:
///
///     q(t) = Re sum_k w_k shapes_k a_k(t),   a_k' = mu_k a_k + of_load_k f,   a(0) = left (q(0), q'(0)),
///
/// Im mu_k >= 0; w_k = 2 for a pair, 1 for a real mu_k.
struct ComplexModes {
  Eigen::VectorXcd mu;       ///< Nm [rad/s]
  Eigen::VectorXd weight;    ///< w_k, Nm
  Eigen::MatrixXcd shapes;   ///< Nr x Nm
  Eigen::MatrixXcd left;     ///< Nm x 2 Nr
  Eigen::MatrixXcd of_load;  ///< Nm x Nr

  /// Nm modes of Nr coordinates, yet to be filled in.
  static ComplexModes of_size(Eigen::Index modes, Eigen::Index coordinates);
  /// Complex amplitude P of q = P e^{i rate t} under the load f e^{i rate t}, Nr; rate is no eigenvalue.
  [[nodiscard]] Eigen::VectorXcd forced(const Eigen::VectorXcd& load, double rate) const;
};

/// The modes. Where damping couples no undamped modes, each of these is an oscillator by itself, in closed
/// form: K~ phi_k = l_k phi_k, mu^2 + d_k mu + l_k = 0, d_k = phi_k^T D~ phi_k. So they are taken where the
/// coupling is within the rounding of D (in norm, 2 epsilon times the largest d_k) and K~ is symmetric and
/// definite, its l_k within a factor of 9e3 / Nr. Of more than 12 coordinates damping may couple the undamped
/// modes weakly, each by at most a quarter of another: they are repeated upon until nothing changes. All
/// others are found in the coordinates of the energy (EnergyForm with `rate`), with long double for up to 12
/// coordinates. None where they are ill-conditioned
/// (critical damping, a rigid-body motion: three digits would cancel between them, four of more than 12
/// coordinates) or M or K~ + rate^2 is not definite.
std::optional<ComplexModes> complex_modes(const MassForm& form, double rate);

}  // namespace signorini
