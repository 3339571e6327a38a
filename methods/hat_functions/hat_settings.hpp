#pragma once
// How a scene is set on nodes, and how its problem is solved.

#include "methods/discretisation/symbols.hpp"
#include "methods/solvers/complementarity_solver.hpp"

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
};

}  // namespace signorini
