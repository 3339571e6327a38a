#pragma once
// Contact conditions as linear complementarity problems on the grid: the rows of docs/theory.md, section 2.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The penetration of the motion without contact forces, scale_c (x_f - g)_c at t_k = k T / N: positive
/// where that motion lies beyond a stop. With the opposite sign it is q of a complementarity problem.
/// \param free_response  coefficients n = 0..H of x_f, (H+1) x Nc [m]; those beyond N / 2 are dropped
/// \param gap      g, Nc [m]
/// \param scale    Nc, the unit of the result per metre
/// \param samples  N >= 1 [-]
/// \return contacts one after another, N Nc
Eigen::VectorXd free_penetration(const Eigen::MatrixXcd& free_response, const Eigen::VectorXd& gap,
                                 const Eigen::VectorXd& scale, int samples);

/// What rigid motions add to a complementarity problem of N samples per contact, scaled: - entries a' in each
/// row of a contact, and sum entries^T z = balance.
struct RigidBorder {
  Eigen::MatrixXd entries;  ///< Nc x m
  Eigen::VectorXd unit;     ///< the mean a of a rigid motion is this times the unknown a', m
  Eigen::VectorXd balance;  ///< m
};

/// \param unit  contact forces over z, Nc [N]
RigidBorder rigid_border(const ContactReceptance& receptance, const Eigen::VectorXd& unit, int samples);

/// E a of an answer z, with which the means of rigid motions shift the contacts; zero without any. Nc [m]
Eigen::RowVectorXd rigid_mean(const ContactReceptance& receptance, const Lcp& lcp,
                              const Eigen::VectorXd& unit, const Eigen::VectorXd& z);

/// The projected equations on N samples, (15) and (16) there, the penalty and the Lipschitz form: find
/// z >= 0 with w = q + A z >= 0 and z^T w = 0, A block-circulant of symbol
///
///     A_n = 1 + B_n for n <= H (projected_law.hpp), 1 above;   q = sqrt(c) (g - x_f).
///
/// The unknown is z / sqrt(c) per contact, contact by contact, N Nc, which makes the blocks of A symmetric in
/// the contacts and their diagonal of order one.
Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples);

/// y = c (x - g) - alpha lambda of that form at t_k = k T / N under contact forces lambda, in its units: z is
/// max(0, y) where lambda = -P z, so that it begins Newton's method (solve_by_newton_from) at these forces.
/// \param lambda  n = 0..H, (H+1) x Nc; mu (MeanBalance) [N]
/// \return contacts one after another, N Nc, then a' and -a' of rigid motions
Eigen::VectorXd augmented_multiplier(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                     int samples);

/// Coefficients n = 0..H of lambda = -P z behind a solution of projected_lcp, (H+1) x Nc [N].
Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics);

/// mu (MeanBalance) behind a solution of projected_lcp, (H+1) x Nc [N].
Eigen::MatrixXcd carried_coefficients(const ProjectedEquations& equations, const Lcp& lcp,
                                      const Eigen::VectorXd& z);

/// e in [0, 1] of the contacts at which a form on nodes imposes an impact law, Nc, empty at the others; no
/// entries: it imposes none at all [-].
using NodalRestitution = std::vector<std::optional<double>>;

/// That of the scene's laws: of a contact with a restitution its own.
NodalRestitution scene_restitution(const Problem& problem);

/// The stops of a scene as a grid of nodes sees them.
struct NodalStops {
  Eigen::VectorXd gap;           ///< g, Nc [m]
  Eigen::VectorXd compliance;    ///< 1 / k_p of a spring stop, 0 of a rigid one, Nc [m/N]
  NodalRestitution restitution;  ///< Nc

  /// s_n of each contact on N nodes (restitution_shift), Nc [-].
  [[nodiscard]] Eigen::VectorXcd shift(int n, int samples) const;
};

/// Gaps and compliances of the scene, with the restitutions that are to be imposed.
NodalStops nodal_stops(const Problem& problem, NodalRestitution restitution);

/// A complementarity problem and the unit of its z.
struct HatForm {
  Lcp lcp;               ///< q and z in scaled units
  Eigen::VectorXd unit;  ///< pressure of z = 1, Nc, > 0 [N]

  /// -lambda behind z at the nodes, N Nc [N].
  [[nodiscard]] Eigen::VectorXd pressure(const Eigen::VectorXd& z) const;
  /// z of nodal pressures, N Nc.
  [[nodiscard]] Eigen::VectorXd scaled(const Eigen::VectorXd& pressure) const;
};

/// z = -lambda / unit >= 0, w = q + A z >= 0, z^T w = 0 for one period on N nodes: at each node
///
///     w_k = g - (x_{k+1} + e x_{k-1}) / (1 + e) - compliance lambda_k,
///
/// the periodic form of the Paoli-Schatzman scheme [paoli2002], or w_k = g - x_k - compliance lambda_k
/// of contacts without restitution. With s_n = restitution_shift, one for each contact, A_n = s_n C_n +
/// compliance and q = g - S x_f, S the operator of symbol s_n; rows and columns are scaled by the unit of
/// their contact.
///
/// \param receptance  C_n and free response for n = 0..N/2 under the scheme of the grid
/// \param samples     N
HatForm hat_form(const ContactReceptance& receptance, const NodalStops& stops, int samples);

}  // namespace signorini
