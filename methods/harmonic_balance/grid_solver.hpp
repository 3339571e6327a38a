#pragma once
// What a method of harmonic balance does on one grid of samples.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"

namespace signorini {

/// The end of one solve on a grid.
struct GridSolution {
  bool solved = false;                   ///< to the method's tolerance
  bool finer_may_help = true;            ///< whether more samples could repair a failure
  Eigen::MatrixXcd lambda = {};          ///< solution or best iterate, n = 0..H, (H+1) x Nc [N]
  double residual = 0.0;                 ///< of the sampled equations, relative [-]
  std::optional<double> condition = {};  ///< estimate for the last linear system; empty: none solved [-]
  std::string message = {};              ///< how it ended, a few words
};

/// Solves the projected equations with the contact integral on N samples. This is the cell of the methods'
/// cube in which they differ: pivoting or Newton on the complementarity problem (fourier-lipschitz,
/// penalty-hbm), Newton-Krylov in the frequency domain (aft-hbm). Each call stands for itself.
/// \param samples   N
/// \param previous  lambda solved on the grid before, or at the frequency before, (H+1) x Nc [N]; empty on
/// the
///        first. Newton's method begins there, pivoting does not
/// \param work      of the whole solve so far; counts are added to it
using GridSolver =
    std::function<GridSolution(const ProjectedEquations& equations, int samples,
                               const Eigen::MatrixXcd& previous, const Start& start, Work& work)>;

/// Pivots and Newton steps of a solve so far.
inline long steps_spent(const Work& work) { return work.pivots.value_or(0) + work.iterations.value_or(0); }

/// Whether a limit on pivots and Newton steps, if there is one, is reached. \param limit  0: none
inline bool is_spent(int limit, const Work& work) { return limit > 0 && steps_spent(work) >= limit; }

/// Adds Newton steps to the work of a solve.
inline void count_iterations(int steps, Work& work) { work.iterations = work.iterations.value_or(0) + steps; }

/// Settings of what is left of a solve: its deadline, and its limit on iterations less what was spent, at
/// least one of them.
SolverSettings remaining(SolverSettings settings, const Start& start, const Work& work);

/// Where a method begins that iterates on contact forces: at those before, those of the guess or none.
/// \param previous  as of GridSolver \return n = 0..H, (H+1) x Nc [N]
Eigen::MatrixXcd first_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& previous,
                             const Start& start);

/// Solves projected_lcp (forms.hpp) by pivoting or by Newton's method as `settings` ask, from the guess of
/// the solve where there is one. A limit on iterations counts what was spent before.
GridSolver lcp_grid_solver(const SolverSettings& settings);

/// Ranges of the shared options, beside that of the solver: pivoting takes nothing from the frequency before.
/// \throws InvalidOption
void validate(const HarmonicOptions& options, ComplementaritySolver solver);

/// Settings of the complementarity solver for a method with these options: `plain` makes `auto` the source
/// paper's Newton iteration.
SolverSettings lcp_settings(const HarmonicOptions& options, ComplementaritySolver solver);

/// Whether the way to the solution is left to such a method: neither `solver` nor `plain` sets it.
inline bool leaves_solver_open(const HarmonicOptions& options, ComplementaritySolver solver) {
  return !options.plain && solver == ComplementaritySolver::automatic;
}

}  // namespace signorini
