#pragma once
// Structures that no spring holds: their rigid motions, and the mean of a load that only contacts can
// balance.

#include <Eigen/Core>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "methods/structure/contact_receptance.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// No motion of the load's period exists; the message names the direction.
class NoPeriodicMotion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// R, Nd x m: a basis of K R = 0 with R^T M R = 1 [kg^-1/2]; none where K is regular, not semidefinite, or
/// some such motion carries no mass. Judged after scaling K to a unit diagonal, or to 1e-2 w^2 M, w the base
/// frequency, where that is larger, eigenvalues to 1e-12: by all of them to 400 coordinates, by inverse
/// iteration beyond. Where K has a skew part, R is of its symmetric part and of K both.
Eigen::MatrixXd rigid_motions(const Problem& problem);

/// m coordinates that hold R, Nd x m of rank m, in place: those of the largest pivots.
std::vector<Eigen::Index> supports(Eigen::MatrixXd R);

/// The scene with springs, w^2 M R R^T M at its base frequency w, and dampers, w M R R^T M, on rigid motions
/// of parts that hold no contact and that no element joins to one that does, or whose springs are below 1e-12
/// of w^2 M: what contacts feel is the same, and periodic motions are isolated at every frequency, those of
/// the parts told from their mean. Loads carry springs and dampers along, so that the parts move as without
/// them. Nothing where every part holds a contact, springs hold the others, or the mean load moves one, which
/// flies away.
std::optional<Problem> with_idle_parts_held(const Problem& problem);

/// Rigid motions in an order that contacts tell.
struct FeltMotions {
  Eigen::MatrixXd motions;  ///< R V, V the right singular vectors of W^T R
  Eigen::Index felt = 0;    ///< how many of them, the first ones, move a contact
};

/// \param motions  R, m >= 1
FeltMotions felt_first(const Problem& problem, const Eigen::MatrixXd& motions);

/// Why no motion has the load's period, as NoPeriodicMotion says it; empty where the mean load is balanced or
/// springs hold the structure.
std::string unbalanced_mean_load(const Problem& problem);

/// The static response of a structure with rigid motions, each held at its mean by a spring of its own:
///
///     u = (K + w^2 M R R^T M)^{-1} f = K^+ f + R R^T f / w^2,   K^+ f = (1 - R R^T M) K^- (1 - M R R^T) f
///
/// the load less what its acceleration as a rigid body takes (inertia relief), on supports that are
/// statically determinate, K^-, and the deflection without rigid part. Where R^T f = 0 neither supports nor
/// springs carry anything.
class HeldStructure {
 public:
  /// \param motions  R, m >= 1  \param rate  w > 0 [rad/s]
  /// \throws SingularStiffness where K is singular on the rest, too
  HeldStructure(const Problem& problem, const Eigen::MatrixXd& motions, double rate);

  /// u, Nd x k. \throws SingularStiffness
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& load) const;

 private:
  Eigen::MatrixXd motions_, moments_;  // R, M R
  double compliance_;                  // 1 / w^2
  SparseLu supported_;                 // K on supports
};

/// Harmonic 0 of a structure with rigid motions R: C_0 and x_f of the held structure at the base frequency,
/// `rigid` and `rigid_load` of the contact receptance. Motions that no contact feels are left out: their mean
/// does not matter. \param result  of which harmonic 0, `rigid` and `rigid_load` are written
/// \throws NoPeriodicMotion where no forces lambda_0 <= 0 balance the mean load, R^T (f_0 + W lambda_0) = 0
void fill_static_receptance(const Problem& problem, const Eigen::MatrixXd& motions,
                            ContactReceptance& result);

/// Factorises Z. False where it is K and this is singular with rigid motions: harmonic 0 of `result` is then
/// filled. \throws SingularStiffness where Z is singular otherwise; NoPeriodicMotion as above
bool factorise_or_hold(const Problem& problem, const HarmonicWeights& weight, DynamicStiffness& stiffness,
                       ContactReceptance& result);

}  // namespace signorini
