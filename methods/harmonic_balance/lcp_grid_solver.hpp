#pragma once
// The projected equations on a grid as a linear complementarity problem.

#include <memory>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/solvers/complementarity_solver.hpp"

namespace signorini {

/// Solves projected_lcp (forms.hpp) by pivoting or by Newton's method as `settings` ask, from the guess of
/// the solve where there is one. A limit on iterations counts what was spent before.
std::unique_ptr<GridSolver> lcp_grid_solver(const SolverSettings& settings);

/// Settings of the complementarity solver for a method with these options: `plain` makes `auto` the source
/// paper's Newton iteration.
SolverSettings lcp_settings(const HarmonicOptions& options, ComplementaritySolver solver);

/// Whether the way to the solution is left to such a method: neither `solver` nor `plain` sets it.
inline bool leaves_solver_open(const HarmonicOptions& options, ComplementaritySolver solver) {
  return !options.plain && solver == ComplementaritySolver::automatic;
}

}  // namespace signorini
