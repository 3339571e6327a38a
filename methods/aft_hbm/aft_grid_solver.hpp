#pragma once
// The alternating frequency/time equations on a grid, by Newton-Krylov and a homotopy in the gap.

#include <memory>

#include "methods/harmonic_balance/grid_solver.hpp"

namespace signorini {

/// How aft-hbm solves on a grid.
struct AftSettings {
  double tolerance = 1e-10;  ///< on |R|_2 / max(|P max(0, y)|_2, |load on the constraint|_2) [-]
  int max_iterations = 0;    ///< Newton steps plus pivots in all; 0: the solvers' own limits [-]
  bool homotopy = true;      ///< whether the gap homotopy follows where Newton fails
};

/// Newton-Krylov (AftResidual) from the grid before, the guess or the contact-free response; failing that,
/// from the end of the gap homotopy of the same equations on the same samples, which pivoting follows
/// (complementarity_solver.hpp).
std::unique_ptr<GridSolver> aft_grid_solver(const AftSettings& settings);

}  // namespace signorini
