#pragma once
// Impulsive orbits a second way: the periodic Green's function of the structure.

#include <Eigen/Core>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// The motion of an open structure under its load and T-periodic impulses,
///
///     u(t) = u_f(t) + sum_j G(t - t_j) p_j,    G(tau) = e^{A tau} (I - e^{A T})^{-1} (0, M^-1 W), 0 <= tau <
///     T,
///
/// summed over the complex modes of A = [0, I; -M^-1 K, -M^-1 D]: for one mass
/// Im(e^{mu tau} / (1 - e^{mu T})) / (m w_d). Shares no step with LinearFlow, whose orbits it checks.
class ModalGreenFunction {
 public:
  /// \param period  T, a whole multiple of the forcing period [s]
  ModalGreenFunction(const ContactDynamics& dynamics, double period);

  /// False where A has no basis of eigenvectors or e^{mu T} = 1 (no unique periodic response).
  [[nodiscard]] bool defined() const { return defined_; }
  /// u and v under the impulses; right-sided where one acts at this very time.
  [[nodiscard]] State state(double time, const std::vector<Impulse>& impulses) const;

 private:
  double period_;
  bool defined_ = false;
  Eigen::VectorXcd mu_;          // 2 Nd
  Eigen::MatrixXcd shapes_;      // Nd x 2 Nd
  Eigen::MatrixXcd excitation_;  // 2 Nd x Nc, (1 - e^{mu T})^-1 included
  std::vector<double> rates_;
  Eigen::MatrixXcd forced_;  // Nd x Nh
};

}  // namespace signorini
