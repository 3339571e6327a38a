#pragma once
// The linear equation of one contact mode without its constraint, in the coordinates that it leaves free and
// in those of its energy.

#include <Eigen/Core>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// In extended precision: a normwise rounding of K to double would change the square of the lowest frequency
/// of a stiff structure by 1e-16 of that of the highest.
using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The free motion of M q'' + D q' + K q = 0 (Nr coordinates) with unit masses,
///
///     z'' + D~ z' + K~ z = 0,   z = L^T q,   M = L L^T,   (K~, D~) = L^-1 (K, D) L^-T.
struct MassForm {
  /// \param M,D,K  Nr x Nr, M symmetric
  MassForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K);

  [[nodiscard]] Eigen::Index size() const { return L.rows(); }  ///< Nr

  bool definite = false;     ///< M is
  ExtendedMatrix L;          ///< Nr x Nr, lower triangular
  ExtendedMatrix q_of_z;     ///< L^-T
  ExtendedMatrix damping;    ///< D~, Nr x Nr
  ExtendedMatrix stiffness;  ///< K~, Nr x Nr
};

/// The same in the coordinates of the energy,
///
///     (e, z')' = B (e, z'),   e = E^T z,   B = [0, E^T; -K~ E^-T, -D~].
///
/// With E E^T = K~ + s^2 the lower left block is s^2 E^-T - E: B is nearly skew, no motion grows on its way
/// however stiff the structure, and rounding of B changes frequencies, not their squares, by that of the
/// largest. Of K~ the symmetric part. Where M or K~ + s^2 is not definite, `definite` is false and E = s.
struct EnergyForm {
  /// \param rate  s, of a motion that matters [rad/s], > 0
  EnergyForm(const MassForm& mass, double rate);

  bool definite = false;  ///< M and K~ + s^2 are
  ExtendedMatrix E;       ///< Nr x Nr, lower triangular
  ExtendedMatrix z_of_e;  ///< E^-T
  ExtendedMatrix B;       ///< 2 Nr x 2 Nr
};

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
