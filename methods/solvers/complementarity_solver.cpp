#include "methods/solvers/complementarity_solver.hpp"

#include <array>
#include <optional>
#include <utility>

#include "methods/solvers/newton.hpp"
#include "methods/solvers/pivoting.hpp"

namespace signorini {

namespace {

// Covering vectors of the restarts, (amplitude, phase) of their wave: the stronger, the more different the
// path from the first, constant one.
constexpr std::array kRestarts{std::pair{0.03, 1.6}, std::pair{0.03, 4.7}, std::pair{0.3, 3.1},
                               std::pair{0.3, 0.0}};

/// The solution that presses everywhere, if it does: permanent contact, which the path of pivots would reach
/// last, having met rattling motions on its way.
std::optional<LcpResult> press_everywhere(Lcp& lcp, double tolerance) {
  const int samples = lcp.matrix.samples();
  for (int c = 0; c < lcp.matrix.contacts(); ++c) {
    if (!(lcp.offset.segment(c * samples, samples).sum() < 0.0))
      return std::nullopt;  // stands open on average
  }
  LcpResult result;
  result.z = lcp.matrix.solve(-lcp.offset);
  if (!result.z.allFinite() || !(result.z.minCoeff() > 0.0)) return std::nullopt;
  result.residual = natural_residual(lcp, result.z);
  if (!(result.residual <= tolerance)) return std::nullopt;
  result.status = LcpStatus::solved;
  return result;
}

}  // namespace

LcpResult solve_lcp(Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  if (settings.solver == ComplementaritySolver::newton) {
    NewtonOptions options{.tolerance = settings.tolerance, .guess = guess, .deadline = settings.deadline};
    if (settings.max_iterations > 0) options.max_iterations = settings.max_iterations;
    return solve_by_newton(lcp, options);
  }
  if (settings.solver == ComplementaritySolver::automatic && guess.size() == 0) {
    if (std::optional<LcpResult> pressed = press_everywhere(lcp, settings.tolerance))
      return *std::move(pressed);
  }
  PivotingOptions options{.max_pivots = settings.max_iterations,
                          .tolerance = settings.tolerance,
                          .guess = guess,
                          .deadline = settings.deadline};
  if (settings.cover_amplitude > 0.0) {
    options.cover = smooth_cover(lcp.matrix.samples(), lcp.matrix.contacts(), settings.cover_amplitude,
                                 settings.cover_phase);
  }
  LcpResult result = solve_by_pivoting(lcp, options);
  if (guess.size() > 0 && result.status != LcpStatus::solved) {
    options.guess.resize(0);
    const long spent = result.pivots;
    result = solve_by_pivoting(lcp, options);
    result.pivots += spent;
  }
  if (settings.solver == ComplementaritySolver::pivoting) return result;
  for (const auto& [amplitude, phase] : kRestarts) {
    // A path that ran out of pivots wanders through many solutions; another cover would wander as long.
    if (result.status != LcpStatus::ray && result.status != LcpStatus::breakdown) break;
    options.cover = smooth_cover(lcp.matrix.samples(), lcp.matrix.contacts(), amplitude, phase);
    LcpResult next = solve_by_pivoting(lcp, options);
    next.pivots += result.pivots;
    result = std::move(next);
  }
  return result;
}

}  // namespace signorini
