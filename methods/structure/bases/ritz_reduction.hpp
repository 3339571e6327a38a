#pragma once
// Reductions of a structure to what its contacts feel, from a space that a Lanczos run has made.

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "methods/structure/bases/block_lanczos.hpp"
#include "methods/structure/bases/massless_elimination.hpp"
#include "methods/structure/bases/reduced_structure.hpp"
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

/// Right-hand sides solved for at a time: bounds what is kept beside the factors [-].
inline constexpr int kMostSolvedAtOnce = 32;
/// Columns in a block that factors solve for several times faster than one by one [-].
inline constexpr Eigen::Index kSolvedTogether = 16;

/// Uniform numbers between -1/2 and 1/2, the same at every call, n x k.
Eigen::MatrixXd random_columns(Eigen::Index n, Eigen::Index k);

/// The obstacle of a structure without a Cholesky factorisation.
inline constexpr std::string_view kNotDefinite = "the stiffness is not positive definite";

/// A space in its Ritz pairs, and in the coordinates of its basis, V^T K V = 1, what acts.
struct SpaceProjection {
  RitzPairs pairs;           ///< of V
  Eigen::MatrixXd ritz;      ///< Ritz vectors in V, k x k, whatever coordinates the pairs have since
  Eigen::MatrixXd contacts;  ///< V^T N, k x Nc
  Eigen::MatrixXd loads;     ///< V^T F, k x Nf
  /// B^T K^-1 B - B^T V V^T B, B = [N, F]: statically, what the space does not hold, (Nc + Nf) x (Nc + Nf).
  Eigen::MatrixXd outside;
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

/// What spaces that are not started from all that acts, B = [N, F], leave out statically. The lowest Ritz
/// vectors Q of a space hold most of B^T K^-1 B; the rest is solved for without them,
///
///     C' = B'^T K^-1 B',    B' = B - K Q Q^T B,    outside = C' - (V^T B')^T V^T B',
///
/// since what a space with Q in it leaves out may be less than the rounding of B^T K^-1 B, and far less than
/// that of its softest directions, which the factors of K know to eps times the condition of K only.
class StaticCompliance {
 public:
  /// \param space  from then on it may grow
  StaticCompliance(const Problem& problem, BlockLanczos& space, const ContactColumns& columns);

  /// The projection of a space that has grown from the one given, pairs not refined. What is known of its
  /// vectors from the last time is not made again.
  SpaceProjection projection(const BlockLanczos& space);
  /// The next projection is of other vectors.
  void forget_vectors() { rows_.resize(0, 0); }
  /// |B_j| in the norm of K^-1, to the rounding of the factors, Nc + Nf.
  [[nodiscard]] Eigen::VectorXd lengths() const;
  /// The largest of s^T M s / s^T K s over s = K^-1 B'_j [s^2].
  [[nodiscard]] double largest_quotient() const { return largest_quotient_; }
  /// C', (Nc + Nf) x (Nc + Nf).
  [[nodiscard]] const Eigen::MatrixXd& rest() const { return rest_; }
  /// B.
  [[nodiscard]] const SparseMatrix& columns() const { return all_; }

 private:
  SparseMatrix all_;
  Eigen::Index contacts_ = 0;
  Eigen::MatrixXd carried_;  // K Q
  Eigen::MatrixXd held_;     // Q^T B
  Eigen::MatrixXd rest_;     // C'
  Eigen::MatrixXd rows_;     // V^T B as far as known,
  Eigen::MatrixXd outside_;  // and C' without those vectors
  double largest_quotient_ = 0.0;
};

/// The lowest `most` Ritz vectors; what the others do goes to the static residual.
ContactReduction reduction_on(const ContactColumns& columns, const SpaceProjection& space, Eigen::Index most);

}  // namespace signorini
