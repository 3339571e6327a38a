#pragma once
// Contact on the nodes of a time grid as a linear complementarity problem: the row of hat functions in the
// table of docs/theory.md, section 2.

#include <Eigen/Core>
#include <optional>

#include "methods/solvers/lcp.hpp"
#include "methods/structure/contact_receptance.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The stops of a scene as a grid of nodes sees them.
struct NodalStops {
  Eigen::VectorXd gap;                ///< g, Nc [m]
  Eigen::VectorXd compliance;         ///< 1 / k_p of a spring stop, 0 of a rigid one, Nc [m/N]
  std::optional<double> restitution;  ///< e in [0, 1] where the form imposes it [-]
};

/// Gaps and compliances of the scene, with the restitution that is to be imposed, if any.
NodalStops nodal_stops(const Problem& problem, const std::optional<double>& restitution);

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
/// without restitution. With s_n = restitution_shift, A_n = s_n C_n + compliance and q = g - S x_f, S the
/// operator of symbol s_n; rows and columns are scaled by the unit of their contact.
///
/// \param receptance  C_n and free response for n = 0..N/2 under the scheme of the grid
/// \param samples     N
HatForm hat_form(const ContactReceptance& receptance, const NodalStops& stops, int samples);

}  // namespace signorini
