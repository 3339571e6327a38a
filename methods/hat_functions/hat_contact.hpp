#pragma once
// Hat functions in time with a contact condition at the nodes: the problem behind hat-lcp, and the coarse
// solve that exact-orbit starts from.

#include <memory>
#include <optional>

#include "methods/discretisation/symbols.hpp"
#include "methods/method.hpp"
#include "methods/solvers/complementarity_solver.hpp"

namespace signorini {

/// How a scene is set on nodes, and how its problem is solved.
struct HatSettings {
  int samples = 256;                                                ///< N >= 4 nodes per period [-]
  HatScheme scheme = HatScheme::galerkin;                           ///< the symbol
  ComplementaritySolver solver = ComplementaritySolver::automatic;  ///< of the complementarity problem
  double tolerance = 1e-10;                                         ///< on LcpResult::residual [-]
  int max_iterations = 0;        ///< pivots or Newton steps; 0: the solver's own limit [-]
  double cover_amplitude = 0.0;  ///< of the covering vector's wave (smooth_cover), in [0, 1) [-]
  double cover_phase = 0.0;      ///< [rad]
};

/// The scene on N nodes as one linear complementarity problem, ready to be solved. Without `restitution` the
/// condition holds on the nodal gaps; with it on g - (x_{k+1} + e x_{k-1}) / (1 + e), the periodic form of
/// the Paoli-Schatzman scheme [paoli2002]. A spring stop adds its compliance. `problem` must outlive the
/// result. \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            std::optional<double> restitution);

}  // namespace signorini
