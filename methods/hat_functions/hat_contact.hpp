#pragma once
// Hat functions in time with a contact condition at the nodes: the problem behind hat-lcp, and the coarse
// solve that exact-orbit starts from.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "methods/complementarity/forms.hpp"
#include "methods/discretisation/symbols.hpp"
#include "methods/method.hpp"
#include "methods/refinement.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// One grid of hat functions.
struct HatSettings {
  int samples = 256;                                                ///< N >= 4 nodes per period [-]
  HatScheme scheme = HatScheme::galerkin;                           ///< the symbol
  ComplementaritySolver solver = ComplementaritySolver::automatic;  ///< of the complementarity problem
  double tolerance = 1e-10;                                         ///< on LcpResult::residual [-]
  int max_iterations = 0;        ///< pivots or Newton steps; 0: the solver's own limit [-]
  double cover_amplitude = 0.0;  ///< of the covering vector's wave (smooth_cover), in [0, 1) [-]
  double cover_phase = 0.0;      ///< [rad]

  /// Whether the way to a solution is left to the method.
  [[nodiscard]] bool way_is_open() const {
    return solver == ComplementaritySolver::automatic && max_iterations == 0;
  }
};

/// The scene on N nodes as one linear complementarity problem, ready to be solved. At a contact without
/// `restitution` the condition holds on the nodal gaps; with it on g - (x_{k+1} + e x_{k-1}) / (1 + e), the
/// periodic form of the Paoli-Schatzman scheme [paoli2002]. A spring stop adds its compliance.
///
/// A solve takes the solver asked for; with `automatic` the first of these attempts that succeeds:
///
///   0. of a structure of more than 2000 coordinates, or 1024 unknowns, whose contacts a march represents
///      (march_obstacle), without a guess or a limit on iterations: Newton's method from the motion that the
///      reduced structure marches to on the same nodes (`march_to_periodic_motion`) in a quarter of the time,
///      after attempt 1; the motion is a guess after that;
///   1. permanent contact: w = 0 at all nodes, one linear solve;
///   2. pivoting from the guess, then cold, then with other covering vectors where a path ends on a ray
///      (`solve_lcp`), as long as the path is short: 4 pivots per unknown, 128 pressures per contact;
///   3. where the path is long (chatter: as many solutions as bounces; contact that lasts on a fine grid):
///      marching in time from rest until the nodes in contact repeat, and Newton's method from there;
///   4. pivoting to the end, 100 pivots per unknown.
///
/// With HatScheme::bdf2, `automatic` and no limit on iterations, massless and spring stops of structures with
/// proportional damping are marched instead (`marched_contact`), on a reduction that the grids share.
///
/// An answer on one grid may still be wrong by its numerical dissipation: `refined_hat_contact` compares
/// grids. `problem` must outlive the result.
/// \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            NodalRestitution restitution);

/// C_n and the free response under a scheme on N nodes, n = 0..N/2: what `hat_form` takes.
/// \throws std::runtime_error if the structure cannot be factorised
ContactReceptance grid_receptance(const Problem& problem, HatScheme scheme, int samples);

/// The weights of a scheme on N nodes of the scene's period, n = 0..N/2 (scheme_weights).
WeightsOfHarmonic grid_weights(const Problem& problem, HatScheme scheme, int samples);

/// Multiplies matrices in front of the nodal contact force, n = 0, 1, ..., by its weight on N nodes
/// (contact_force_weight).
void weigh_contact_force(std::vector<Eigen::MatrixXcd>& matrices, HatScheme scheme, int samples);

/// The motion behind nodal pressures -lambda [N], N Nc one contact after another: x_n = x_free,n + C_n
/// lambda_n. Null where it is not finite. \param mean  E a of the rigid motions, Nc, added to x_0 where there
/// are some [m]
std::shared_ptr<const Trajectory> nodal_motion(const ContactReceptance& receptance,
                                               const Eigen::VectorXd& pressure, int samples,
                                               const Eigen::RowVectorXd& mean);

/// Whether a grid of so many nodes resolves the load.
Support grid_support(const Problem& problem, int samples);

/// Nodes of the finest grid that is tried unasked.
inline constexpr int kFinestHatGrid = 4096;

/// Nodes of the first grid: 256, doubled until there are 16 per oscillation of the load's highest harmonic,
/// as far as the finest grid has them.
int coarsest_hat_grid(const Problem& problem);

/// The scene on the coarsest grid and on four times as many nodes, up to the finest.
/// \param settings  of all grids but for the nodes
/// \param restitution  as of hat_contact; `problem` must outlive the grids
Resolutions hat_grids(const Problem& problem, const HatSettings& settings, NodalRestitution restitution);

/// The scene on those grids, one after another, until two agree within 5 % (`refined_until_agreed`). A grid
/// dissipates or feeds the motion at impacts, at a rate that falls with N, so that an answer on one grid
/// alone may be of another motion (docs/decisions/0014). Motions below 1e-6 of the static deflection are at
/// rest; a grid that would take more than about a second is not asked. \throws std::runtime_error if the
/// structure cannot be factorised
std::unique_ptr<PreparedMethod> refined_hat_contact(const Problem& problem, const HatSettings& settings,
                                                    NodalRestitution restitution);

}  // namespace signorini
