#pragma once
// The flow of a contact mode by the matrix exponential.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// e^A of a square matrix, by scaling and squaring with Padé approximants (Higham 2005); its error is a small
/// multiple of the rounding of ||A|| ||e^A|| as long as no power of e^A on the way is much larger than e^A.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

/// The exponential of the structure augmented by the harmonic generators of the load, (cos, sin)' =
/// rate (-sin, cos), in the coordinates of the energy (EnergyForm): there no motion grows on its way, and
/// squaring the exponential loses no digits to it. Defined for every structure, resonances and critical
/// damping included; each evaluation forms an exponential.
class ExponentialFlow final : public LinearFlow {
 public:
  /// \param energy  equations.energy()
  ExponentialFlow(ModeEquations equations, const EnergyForm& energy);

  [[nodiscard]] std::unique_ptr<LinearArc> arc() const override;
  [[nodiscard]] Eigen::MatrixXd transition(double duration) const override;
  [[nodiscard]] State response(const std::vector<Impulse>& impulses) const override;

 private:
  class Arc;

  // The coordinates of the energy, e of the position and z' of the velocity, Nr each.
  Eigen::MatrixXd u_of_e_, v_of_z_;  // Nd x Nr
  Eigen::MatrixXd e_of_u_, z_of_v_;  // Nr x Nd
  Eigen::MatrixXd generator_;        // of (e, z', cos and sin of each harmonic)
  Eigen::MatrixXd output_;           // outputs x generator size
  double fastest_rate_ = 0.0;        // of structure and load [rad/s]
};

}  // namespace signorini
