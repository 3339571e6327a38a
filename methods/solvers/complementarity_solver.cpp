#include "methods/solvers/complementarity_solver.hpp"

#include <array>
#include <optional>
#include <utility>

#include "methods/solvers/covering_vector.hpp"
#include "methods/solvers/newton.hpp"
#include "methods/solvers/pivoting.hpp"

namespace signorini {

namespace {

// Covering vectors of the restarts, (amplitude, phase) of their wave: the stronger, the more different the
// path from the first, constant one.
constexpr std::array kRestarts{std::pair{0.03, 1.6}, std::pair{0.03, 4.7}, std::pair{0.3, 3.1},
                               std::pair{0.3, 0.0}};

Eigen::VectorXd wave(const Lcp& lcp, double amplitude, double phase) {
  return smooth_cover(lcp.samples, lcp.contacts(), amplitude, phase);
}

LcpResult by_newton(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  NewtonOptions options{.tolerance = settings.tolerance, .guess = guess, .deadline = settings.deadline};
  if (settings.max_iterations > 0) options.max_iterations = settings.max_iterations;
  return solve_by_newton(lcp, options);
}

/// The solution with z > 0 everywhere, if there is one: permanent contact, which the path of pivots would
/// reach last, having met rattling motions on its way.
std::optional<LcpResult> permanent_contact(const Lcp& lcp, double tolerance) {
  for (int c = 0; c < lcp.contacts(); ++c) {
    // Open on average: no need to solve.
    if (!(lcp.offset.segment(c * lcp.samples, lcp.samples).sum() < 0.0)) return std::nullopt;
  }
  LcpResult result;
  result.z = lcp.matrix->solve(-lcp.offset);
  if (!result.z.allFinite() || !(result.z.minCoeff() > 0.0)) return std::nullopt;
  result.residual = natural_residual(lcp, result.z);
  if (!(result.residual <= tolerance)) return std::nullopt;
  result.status = LcpStatus::solved;
  return result;
}

/// The next path, its pivots added to those of the path before.
LcpResult another_path(const Lcp& lcp, const PivotingOptions& options, const LcpResult& before) {
  LcpResult result = solve_by_pivoting(lcp, options);
  result.pivots += before.pivots;
  return result;
}

/// Whether another covering vector may help. A path that ran out of pivots wanders through many solutions;
/// with another cover it would wander as long.
bool worth_a_restart(const LcpResult& result) {
  return result.status == LcpStatus::ray || result.status == LcpStatus::breakdown;
}

}  // namespace

LcpResult solve_lcp(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess) {
  if (settings.solver == ComplementaritySolver::newton) return by_newton(lcp, settings, guess);
  const bool automatic = settings.solver == ComplementaritySolver::automatic;
  const bool warm = guess.size() > 0;
  if (automatic && !warm) {
    if (std::optional<LcpResult> pressed = permanent_contact(lcp, settings.tolerance))
      return *std::move(pressed);
  }
  PivotingOptions path{.max_pivots = settings.max_iterations,
                       .tolerance = settings.tolerance,
                       .guess = guess,
                       .deadline = settings.deadline};
  if (settings.cover_amplitude > 0.0) path.cover = wave(lcp, settings.cover_amplitude, settings.cover_phase);
  LcpResult result = solve_by_pivoting(lcp, path);
  if (warm && result.status != LcpStatus::solved) {
    path.guess.resize(0);
    result = another_path(lcp, path, result);
  }
  if (!automatic) return result;
  for (const auto& [amplitude, phase] : kRestarts) {
    if (!worth_a_restart(result)) break;
    path.cover = wave(lcp, amplitude, phase);
    result = another_path(lcp, path, result);
  }
  return result;
}

}  // namespace signorini
