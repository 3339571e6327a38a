#pragma once
// A structure in the coordinates of its energy, in which no free motion grows on its way.

#include <Eigen/Core>

namespace signorini {

/// In extended precision: a normwise rounding of K to double would change the square of the lowest frequency
/// of a stiff structure by 1e-16 of that of the highest.
using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The free motion of M q'' + D q' + K q = 0 (Nr coordinates, M definite) in the coordinates of its energy,
///
///     (e, z')' = B (e, z'),   e = E^T z,   z = L^T q,   M = L L^T,
///     B = [0, E^T; -K~ E^-T, -D~],   (K~, D~) = L^-1 (K, D) L^-T.
///
/// With E E^T = K~ + s^2 the lower left block is s^2 E^-T - E: B is nearly skew, no motion grows on its way
/// however stiff the structure, and rounding of B changes frequencies, not their squares, by that of the
/// largest. Where M or K~ + s^2 is not definite, `definite` is false and E = s.
struct EnergyForm {
  /// \param rate  s, of a motion that matters [rad/s], > 0
  EnergyForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K, double rate);

  [[nodiscard]] Eigen::Index size() const { return L.rows(); }  ///< Nr

  bool definite = false;
  ExtendedMatrix L, E;            ///< Nr x Nr, lower triangular
  ExtendedMatrix z_of_e, q_of_z;  ///< E^-T and L^-T
  ExtendedMatrix B;               ///< 2 Nr x 2 Nr
};

}  // namespace signorini
