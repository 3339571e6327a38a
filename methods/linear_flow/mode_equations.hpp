#pragma once
// The linear equation of one contact mode without its constraint, in the coordinates that it leaves free.

#include <Eigen/Core>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/linear_flow/modes/energy_form.hpp"

namespace signorini {

/// One contact mode A in the coordinates that it leaves free (Stops::free_form): u = u_g + Q q with
///
///     Q^T (M, D_A, K_A) Q (q'', q', q) = Q^T (f_A(t) - K u_g),
///
/// the parts xi of relaxing contacts by u and what relaxes alone (RelaxingForm), and the outputs
/// x_0..x_Nc-1, lambda_A as a linear function of (u, xi, v) and of the load.
struct ModeEquations {
  /// \param dynamics  of the scene, kept by the caller
  ModeEquations(const ContactDynamics& dynamics, ContactMode contacts);

  [[nodiscard]] int size() const { return static_cast<int>(form.basis.rows()); }        ///< Nd
  [[nodiscard]] int positions() const { return structure().positions(); }               ///< Np, of u and xi
  [[nodiscard]] int states() const { return structure().states(); }                     ///< of (u, xi, v)
  [[nodiscard]] Eigen::Index free() const { return form.basis.cols(); }                 ///< Nr
  [[nodiscard]] Eigen::Index outputs() const { return output_of_state.rows(); }         ///< Nc + |A|
  [[nodiscard]] Eigen::Index harmonics() const { return form.load.cols(); }             ///< Nh
  [[nodiscard]] const std::vector<double>& rates() const { return structure().rates; }  ///< h omega [rad/s]
  /// Of the scene.
  [[nodiscard]] const FlowStructure& structure() const { return dynamics->structure(); }
  /// Q^T (f_h - K u_g), Nr [N].
  [[nodiscard]] Eigen::VectorXcd reduced_load(Eigen::Index h) const;
  /// Structure and springs of the mode, in extended precision.
  [[nodiscard]] MassForm mass_form() const;
  /// Row of lambda_j among the outputs; -1 where contact j is open.
  [[nodiscard]] Eigen::Index force_row(int contact) const;

  const ContactDynamics* dynamics;  ///< of the scene
  ContactMode mode;                 ///< A
  FreeForm form;                    ///< u_g, Q, D_A, K_A and f_A
  Eigen::MatrixXd output_of_state;  ///< outputs x (Np + Nd)
  Eigen::MatrixXcd output_of_load;  ///< outputs x Nh
};

}  // namespace signorini
