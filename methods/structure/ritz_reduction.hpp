#pragma once
// Reductions of a structure to what its contacts feel, from a space that a Lanczos run has made.

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "methods/structure/block_lanczos.hpp"
#include "methods/structure/massless_elimination.hpp"
#include "methods/structure/reduced_structure.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The load as real columns of unit length, f(t) = Re sum_h F weight_h e^{i rate_h t}.
struct LoadColumns {
  std::vector<Contact> columns;  ///< of F, Nf of them: where each acts, as a contact would [-]
  /// h omega of the harmonics in the load, ascending, 0 always the first [rad/s].
  std::vector<double> rates;
  Eigen::MatrixXcd weight;  ///< Nf x Nh [N]

  /// Coefficients phi_n, f(t) = sum_n F phi_n e^{i n base t}, n = 0..H, (H+1) x Nf [N].
  /// \param base  rate of harmonic 1, a whole part of the load's [rad/s]
  [[nodiscard]] Eigen::MatrixXcd coefficients(double base, int harmonics) const;
};

/// Those of a scene: real and imaginary part of each harmonic as far as they are not zero.
LoadColumns load_columns(const Problem& problem);

/// What acts on the coordinates with mass, those without eliminated: columns of a scene's size, zero at
/// massless coordinates, so that whatever K^-1 makes of them moves those statically.
struct ContactColumns {
  std::string obstacle;         ///< why there is no reduction, one clause; the rest is then empty
  ProportionalDamping damping;  ///< alpha [1/s], beta [s]
  LoadColumns load;             ///< Nf columns
  SparseMatrix normals;         ///< N, of the contacts, Nd x Nc [-]
  SparseMatrix pushes;          ///< F likewise, of the load, Nd x Nf [-]
  /// [W, F]_b^T K_bb^-1 [W, F]_b of the massless coordinates b, (Nc + Nf) x (Nc + Nf) [m/N].
  Eigen::MatrixXd compliance;
  /// K_bb^-1 [W, F]_b on the coordinates b, zero elsewhere, Nd x (Nc + Nf) [m/N].
  SparseMatrix following;
  Eigen::Index with_mass = 0;  ///< coordinates with mass

  /// [N, F].
  [[nodiscard]] SparseMatrix all() const;
  /// Vectors at most: more than coordinates with mass would be rounding.
  [[nodiscard]] Eigen::Index most() const { return with_mass; }
};

/// Those of a scene. An obstacle: damping that is not proportional, massless coordinates that cannot be
/// eliminated, neither contacts nor loads.
ContactColumns contact_columns(const Problem& problem);

/// [A, B].
SparseMatrix side_by_side(const SparseMatrix& A, const SparseMatrix& B);

/// The obstacle of a structure without a Cholesky factorisation.
inline constexpr std::string_view kNotDefinite = "the stiffness is not positive definite";

/// A space in its Ritz pairs, and in the coordinates of its basis, V^T K V = 1, what acts.
struct SpaceProjection {
  RitzPairs pairs;           ///< of V
  Eigen::MatrixXd ritz;      ///< Ritz vectors in V, k x k, whatever coordinates the pairs have since
  Eigen::MatrixXd contacts;  ///< V^T N, k x Nc
  Eigen::MatrixXd loads;     ///< V^T F, k x Nf
  Eigen::MatrixXd outside;   ///< N^T K^-1 N - N^T V V^T N, what the space does not hold, Nc x Nc
};

/// That of a space that was started from [N, F], which holds all of N^T K^-1 N. \param contacts  Nc
SpaceProjection projection_from_start(const BlockLanczos& space, Eigen::Index contacts);

/// Replaces the lowest Ritz pairs, twelve at most, by those of a projection of K and M on their vectors in
/// twice the precision, and what contacts and loads see of them; the projection then is in Ritz coordinates
/// (`pairs.vectors` = 1). The factors of K know its lowest eigenvalues to eps times its condition, which for
/// the bending of a slender bar is 1e-7; the projection knows them to rounding, the error of its vectors
/// squared.
/// \return the rounding that is left, relative to K: by how much the highest of these pairs was wrong, which
/// the
///          next ones may be, and the square of how much any of them was [-]
double refine_lowest(const Problem& problem, const BlockLanczos& space, const ContactColumns& columns,
                     SpaceProjection& projection);

/// The lowest `most` Ritz vectors; what the others do goes to the static residual.
ContactReduction reduction_on(const ContactColumns& columns, const SpaceProjection& space, Eigen::Index most);

/// A reduction of its lowest `most` vectors; what the others do goes to the static residual.
ContactReduction lowest_of(const ContactReduction& reduction, Eigen::Index most);

}  // namespace signorini
