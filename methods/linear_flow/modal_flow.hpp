#pragma once
// The flow of a contact mode by its complex modes.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "methods/linear_flow/complex_modes.hpp"
#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

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
