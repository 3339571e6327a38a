#pragma once
// The alternating frequency/time equations on a grid, by Newton-Krylov and a homotopy in the gap.

#include "methods/harmonic_balance/grid_solver.hpp"

namespace signorini {

/// Newton-Krylov on the sampled equations (ProjectedResidual), every product of which goes from harmonics to
/// samples, through the contact law and back, from the grid before, the guess or the contact-free response;
/// failing that, from the end of the gap homotopy of the same equations on the same samples, which pivoting
/// follows (complementarity_solver.hpp). \param settings  tolerance on ProjectedResidual::error; limit on
/// Newton steps plus pivots in all \param homotopy  whether the gap homotopy follows where Newton fails
GridSolver aft_grid_solver(const SolverSettings& settings, bool homotopy = true);

}  // namespace signorini
