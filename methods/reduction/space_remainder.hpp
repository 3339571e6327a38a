#pragma once
// What a Krylov space leaves out of the responses of a structure, and the directions that would take it in.

#include <Eigen/Core>
#include <complex>

#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/harmonic_pencil.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

/// kappa = 1 + i beta w, mu = -w^2 + i alpha w of Z = kappa K + mu M, without a load. \param rate  w [rad/s]
HarmonicPencil response_pencil(const ProportionalDamping& damping, double rate);

/// What a space V with V^T K V = 1 leaves out of the response u to a force B b at one harmonic, B = [N, F].
/// With t = V^T M V, r = V^T B, T = K^-1 M,
///
///     T V = V t + X,    K^-1 B = V r + R,    X and R K-orthogonal to V,
///     u ~ V y + R b / kappa,    (kappa + mu t) y = r b,
///     K^-1 (B b - Z u) = -mu (X y + T R b / kappa).
///
/// The length of that in the norm of K is at most rho(b) = |mu| (|X y| + (|X^T K R b| + s |R b|) / |kappa|),
/// s the norm of T on what is K-orthogonal to V: of the Ritz pairs, from the largest down, the first that has
/// not converged gives it, or the largest Rayleigh quotient of static responses, which is an estimate as any
/// largest eigenvalue of a Krylov space is. With y_j the
/// response to a unit force at contact j,
///
///     |x_j - x_j^space| <= (|R e_j| + |mu X y_j|) rho(b) / d + |mu X y_j| |R b| / |kappa|,
///
/// d = min |kappa + mu theta| over the spectrum of K^-1 M (`distance_from_singular`),
/// the last term since u is not quite the Galerkin solution in V and R b. With y_j = 0 in that argument the
/// bracket is |e_j| in the norm of K^-1 and there is no last term: the smaller bracket of the two is taken.
/// Where the space was started from all of B, R is rounding and measured as such.
class SpaceRemainder {
 public:
  SpaceRemainder() = default;
  /// \param space       with the vectors that would come next
  /// \param projection  of it
  /// \param statics     of B; null for a space started from it
  SpaceRemainder(const BlockLanczos& space, const SpaceProjection& projection,
                 const StaticCompliance* statics);

  /// What the bound under the forces b_n, n = 0..H, consists of.
  struct Residuals {
    Eigen::MatrixXcd acting;         ///< mu X y in the vectors that would come next, f x (H+1)
    Eigen::MatrixXcd ahead;          ///< R b likewise, f x (H+1)
    Eigen::VectorXd beyond;          ///< |R b| without that, H+1
    Eigen::RowVectorXd left_out;     ///< |mu X y| that rounding has kept out of both, H+1
    Eigen::VectorXd ratio;           ///< |mu / kappa|, H+1 [1/s^2]
    Eigen::VectorXd least;           ///< d, H+1
    Eigen::VectorXd elastic;         ///< |kappa|, H+1
    Eigen::VectorXd factor;          ///< the largest bracket of the bound, over d, H+1
    Eigen::VectorXd cross;           ///< the largest |mu X y_j| / |kappa|, H+1
    Eigen::VectorXd cross_left_out;  ///< the same of what rounding has kept out, H+1
  };
  /// \param theta     Ritz values, k
  /// \param ports     r in the Ritz vectors, k x (Nc + Nf)
  /// \param contacts  Nc; with 0 `factor` and the crosses, which `weighted_bound` does not need, mean
  ///                  nothing
  /// \param acting    b_n, (Nc + Nf) x (H+1) [N]
  [[nodiscard]] Residuals residuals(const ProportionalDamping& damping, double base,
                                    const Eigen::VectorXd& theta, const Eigen::MatrixXd& ports,
                                    Eigen::Index contacts, const Eigen::MatrixXcd& acting) const;
  /// The bound of |x_j - x_j^space| at each harmonic, the largest over contacts, H+1 [m].
  [[nodiscard]] Eigen::VectorXd bound(const Residuals& residuals, const Eigen::MatrixXcd& acting) const;

  /// The bound of |sum_j b_j (q_j - q_j^space)| at each harmonic, q = B^T u under the forces `acting`: that
  /// of one contact with the response to b in place of that to e_j, hence small of second order where the
  /// space has both responses, H+1 [N m]. \param of_weights  residuals of the forces `weights` \param weights
  /// b_n, (Nc + Nf) x (H+1)
  [[nodiscard]] Eigen::VectorXd weighted_bound(const Residuals& of_weights, const Eigen::MatrixXcd& weights,
                                               const Residuals& residuals,
                                               const Eigen::MatrixXcd& acting) const;

  /// Whether what `left_out` adds to the root mean square over time of the bound is no small part of
  /// `tolerance` [m].
  [[nodiscard]] static bool left_out_matters(const Residuals& residuals, double tolerance);

  /// Directions among the vectors that would come next in which the residuals of all harmonics are longest,
  /// each as it counts in the bound, orthonormal, the longest last: as many as leave a part of `tolerance`
  /// [m], 64 at most.
  [[nodiscard]] Eigen::MatrixXd longest(const Residuals& residuals, double tolerance) const;
  /// Combinations of the columns of B whose static response is to be offered to the space, as what lies in
  /// neither is then longest; none if that is a small part of `tolerance` [m] already.
  [[nodiscard]] Eigen::MatrixXd missing_columns(const Residuals& residuals, const Eigen::MatrixXcd& acting,
                                                double tolerance) const;

 private:
  /// What the space leaves of a force, and of it the response that is missing statically, of each harmonic.
  struct Lengths {
    Eigen::VectorXd whole;  // rho(b)
    Eigen::VectorXd ahead;  // |R b| in the vectors that would come next
    Eigen::VectorXd still;  // |R b|
  };
  [[nodiscard]] Lengths lengths(const Residuals& residuals, const Eigen::MatrixXcd& acting) const;
  /// The brackets of the bound, the largest over contacts.
  struct OfContacts {
    double bracket = 0.0;                // |R e_j| + |mu X y_j|
    double moved = 0.0, left_out = 0.0;  // |mu X y_j| in the vectors that would come next, and elsewhere
  };
  [[nodiscard]] OfContacts of_contacts(const HarmonicPencil& pencil, const Eigen::VectorXd& theta,
                                       const Eigen::MatrixXd& contacts) const;

  Eigen::MatrixXd outside_;      // X in the vectors that would come next, of Ritz vectors, f x k
  Eigen::MatrixXd left_out_;     // |what rounding kept out of X y| <= |left_out y|
  Eigen::MatrixXd ahead_;        // R in the vectors that would come next, f x (Nc + Nf)
  Eigen::MatrixXd beyond_;       // Gram matrix of R without that, (Nc + Nf) x (Nc + Nf)
  Eigen::VectorXd still_;        // |R e_j|, Nc + Nf
  double longest_static_ = 0.0;  // the largest |e_j|
  double rounding_ = 0.0;        // of squares of what beyond_ measures, of a unit force
  double smoothing_ = 0.0;       // s
  double left_out_of_start_ = 0.0;
};

}  // namespace signorini
