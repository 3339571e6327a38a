#pragma once
// A linear equation of motion in coordinates with unit masses, and in those of its energy.

#include "methods/solvers/extended/matrix.hpp"

namespace signorini {

/// The free motion of M q'' + D q' + K q = 0 (Nr coordinates) with unit masses,
///
///     z'' + D~ z' + K~ z = 0,   z = L^T q,   M = L L^T,   (K~, D~) = L^-1 (K, D) L^-T.
///
/// In extended precision: a normwise rounding of K~ to double would change the square of the lowest frequency
/// of a stiff structure by 1e-16 of that of the highest.
struct MassForm {
  /// \param M,D,K  Nr x Nr, M symmetric
  MassForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K);

  [[nodiscard]] Eigen::Index size() const { return L.rows(); }  ///< Nr

  bool definite = false;   ///< M is
  bool unit = false;       ///< whether M, and so L, is the identity, as of the vectors of a reduced structure
  ExtendedMatrix L;        ///< Nr x Nr, lower triangular
  ExtendedMatrix q_of_z;   ///< L^-T
  ExtendedMatrix damping;  ///< D~, Nr x Nr
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

}  // namespace signorini
