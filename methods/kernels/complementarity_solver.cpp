#include "methods/kernels/complementarity_solver.hpp"

#include <utility>

#include "methods/kernels/newton.hpp"
#include "methods/kernels/pivoting.hpp"

namespace signorini {

namespace {

// Covering vectors of the restarts: the more uneven, the more different the path. The ratios are
// irrational (golden, silver, plastic), so that no two entries tie.
constexpr std::array kRestarts{std::pair{1e-3, 0.6180339887498949}, std::pair{0.9, 0.41421356237309515},
                               std::pair{1.6, 0.7548776662466927}, std::pair{1.9, 0.5698402909980532}};

}  // namespace

LcpResult solve_lcp(Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  if (settings.solver == ComplementaritySolver::newton) {
    NewtonOptions options{.tolerance = settings.tolerance, .guess = guess, .deadline = settings.deadline};
    if (settings.max_iterations > 0) options.max_iterations = settings.max_iterations;
    return solve_by_newton(lcp, options);
  }
  PivotingOptions options{.max_pivots = settings.max_iterations,
                          .tolerance = settings.tolerance,
                          .guess = guess,
                          .deadline = settings.deadline};
  LcpResult result = solve_by_pivoting(lcp, options);
  if (guess.size() > 0 && result.status != LcpStatus::solved) {
    options.guess.resize(0);
    const long spent = result.pivots;
    result = solve_by_pivoting(lcp, options);
    result.pivots += spent;
  }
  if (settings.solver == ComplementaritySolver::pivoting) return result;
  for (std::size_t k = 1; k < kRestarts.size() && result.status != LcpStatus::solved; ++k) {
    if (result.status == LcpStatus::interrupted) break;
    options.cover = smooth_cover(lcp.matrix.size(), kRestarts[k].first, kRestarts[k].second);
    LcpResult next = solve_by_pivoting(lcp, options);
    next.pivots += result.pivots;
    result = std::move(next);
  }
  return result;
}

}  // namespace signorini
