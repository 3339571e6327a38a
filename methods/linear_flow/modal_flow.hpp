#pragma once
// The flow of a contact mode by its complex modes, and these modes.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"

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

  /// Complex amplitude P of q = P e^{i rate t} under the load f e^{i rate t}, Nr; rate is no eigenvalue.
  [[nodiscard]] Eigen::VectorXcd forced(const Eigen::VectorXcd& load, double rate) const;
};

/// The modes, found in the coordinates of the energy, with long double for up to 12 coordinates. None where
/// they are ill-conditioned (critical damping, a rigid-body motion: more than three digits would cancel
/// between them) or M or K is not definite.
std::optional<ComplexModes> complex_modes(const EnergyForm& form);

/// The complex modes of a mode's structure; empty where they cannot carry its flow: they are ill-conditioned
/// (critical damping, a rigid-body motion), or the load resonates with one of them, so that the periodic
/// response and the free motion would cancel in their leading digits.
std::optional<ComplexModes> modes_of_flow(const ModeEquations& equations, const EnergyForm& energy);

/// With the complex modes (mu_k, U_k) of the structure, proportional damping or not,
///
///     u(t) = Re sum_k w_k U_k a_k e^{mu_k (t - t0)} + Re sum_h P_h e^{i h omega t},
///
/// Im mu_k >= 0, w_k = 2 for a pair and 1 for a real mu_k (ComplexModes), P_h the periodic response to the
/// load. Evaluations allocate nothing.
class ModalFlow final : public LinearFlow {
 public:
  /// \param modes  modes_of_flow(equations, equations.energy())
  ModalFlow(ModeEquations equations, const ComplexModes& modes);

  [[nodiscard]] std::unique_ptr<LinearArc> arc() const override;
  [[nodiscard]] Eigen::MatrixXd transition(double duration) const override;
  [[nodiscard]] State response(const std::vector<Impulse>& impulses) const override;

 private:
  class Arc;

  Eigen::VectorXcd mu_;               // Nm
  Eigen::VectorXd weight_;            // w_k
  Eigen::MatrixXcd shapes_;           // U, Nd x Nm
  Eigen::MatrixXcd left_;             // Nm x 2 Nd: a = left ((u, v) - forced)
  Eigen::MatrixXcd forced_;           // P, Nd x Nh
  Eigen::MatrixXcd row_of_mode_;      // outputs x Nm, w_k included
  Eigen::MatrixXcd row_of_harmonic_;  // outputs x Nh
};

}  // namespace signorini
