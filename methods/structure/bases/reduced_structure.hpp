#pragma once
// The form of a structure that is reduced to what its contacts feel.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "problems/matrix_properties.hpp"

namespace signorini {

/// A structure on m vectors phi_k that its damping does not couple, phi_k^T M phi_k = 1, phi_k^T D phi_k =
/// d_k, phi_k^T K phi_k = omega_k^2, orthogonal in all three. With n_k = W^T phi_k,
///
///     q_k'' + d_k q_k' + omega_k^2 q_k = phi_k^T f + n_k^T lambda,
///     x = sum_k n_k q_k + xi,    beta xi' + xi = s_m(t) + C_m lambda,
///     C_m = W^T K^-1 W - sum_k n_k n_k^T / omega_k^2,    s_m = W^T K^-1 f - sum_k n_k phi_k^T f / omega_k^2.
///
/// What the vectors leave out follows statically, as MacNeal's residual flexibility does [macneal1971]; with
/// damping it relaxes with the time beta, which is right for waves far above omega_m and far below. So no
/// coordinate of a contact has mass of its own [monjaraz2022], and the motion of massless contacts needs no
/// impact law. C_m is positive semi-definite, and not smaller than the compliance of the massless
/// coordinates.
///
/// Contacts that have mass and an impact law become another model, whose mass at the contact is that of the
/// vectors: only a start for one of the whole structure.
struct ContactReduction {
  std::string obstacle;        ///< why this cannot be done, one clause; the rest is then empty
  Eigen::VectorXd damping;     ///< d_k >= 0, m [1/s]
  double relaxation = 0.0;     ///< beta >= 0 [s]
  Eigen::VectorXd squares;     ///< omega_k^2 > 0, rising, m [1/s^2]
  Eigen::MatrixXd rows;        ///< row k is n_k^T, m x Nc [kg^-1/2]
  Eigen::MatrixXd compliance;  ///< C_m, Nc x Nc [m/N]
  /// h omega of the harmonics in the load, ascending, 0 always the first [rad/s].
  std::vector<double> rates;
  Eigen::MatrixXcd load;   ///< phi_k^T f of e^{i h omega t}, its real part to be taken; m x Nh [N kg^-1/2]
  Eigen::MatrixXcd shift;  ///< s_m likewise, Nc x Nh [m]
  bool complete = false;   ///< whether the vectors span all that contacts and loads can excite

  /// None, for this reason.
  static ContactReduction refused(std::string_view obstacle) {
    ContactReduction result;
    result.obstacle = obstacle;
    return result;
  }
  /// Takes d_k = alpha + beta omega_k^2 and beta from D = alpha M + beta K.
  void damp(const ProportionalDamping& by) {
    damping = (by.alpha + by.beta * squares.array()).matrix();
    relaxation = by.beta;
  }

  /// m.
  [[nodiscard]] Eigen::Index vectors() const { return squares.size(); }
  /// Nc.
  [[nodiscard]] Eigen::Index contacts() const { return compliance.rows(); }
};

}  // namespace signorini
