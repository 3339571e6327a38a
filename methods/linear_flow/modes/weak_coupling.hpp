#pragma once
// Undamped and complex modes, and damping that couples those weakly.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/solvers/extended/matrix.hpp"

namespace signorini {

inline constexpr Eigen::Index kLongDouble = 12;  ///< coordinates up to which extended precision is cheap

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

/// The undamped modes phi_k: z_k'' + d_k z_k' + sum_j c_kj z_j' + l_k z_k = 0.
struct RealModes {
  std::vector<long double> squares;  ///< l_k, n, ascending [1/s^2]
  std::vector<long double> damping;  ///< d_k, n [1/s]
  ExtendedMatrix shapes;             ///< phi_k of z, orthonormal, n x n
  ExtendedMatrix coupling;           ///< c_kj by damping, n x n, zero on its diagonal [1/s]
};

/// The factor by which digits may cancel between the modes of a structure of so many coordinates.
double most_cancelled(Eigen::Index coordinates);

/// The modes of damping that couples the undamped ones weakly: with y_k = 1,
///
///     mu^2 + (d_k + (C y)_k) mu + l_k = 0,   y_j = -mu (C y)_j / (mu^2 + d_j mu + l_j),   j != k,
///
/// by repetition, which contracts as much as the coupling is weak: some 1e2 n^3 operations in double for all,
/// where eigenvectors take some 4e2 n^3. Empty where that does not converge, or a mode is ill-conditioned.
/// \param rate  of the energy [rad/s]
/// \return in the coordinates y, z = sum_j phi_j y_j, and under their forces
std::optional<ComplexModes> weakly_coupled(const RealModes& real, double rate);

/// Damping that couples undamped modes by few dashpots: B diag(strength) B^T without its diagonal.
struct DashpotCoupling {
  Eigen::MatrixXd shares;    ///< B, n x m
  Eigen::VectorXd strength;  ///< m, of either sign
};

/// The same with that coupling, by 2 n m operations a repetition in place of n^2. \param real  its squares
/// and damping, n; shapes and coupling are not read
std::optional<ComplexModes> weakly_coupled(const RealModes& real, const DashpotCoupling& coupling,
                                           double rate);

/// Modes of y, under the forces of y, as those of q = S y. \param S,R  Nr x n, R^T S = 1
ComplexModes in_coordinates(ComplexModes modes, const Eigen::MatrixXd& S, const Eigen::MatrixXd& R);

}  // namespace signorini
