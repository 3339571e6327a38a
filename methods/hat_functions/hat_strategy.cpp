#include "methods/hat_functions/hat_strategy.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "methods/hat_functions/period_marching.hpp"
#include "methods/solvers/complementarity_solver.hpp"
#include "methods/solvers/newton.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Pivots per unknown after which a path counts as long: scenes without chatter need one to two.
constexpr int kShortPath = 4;
// The same after which it is given up.
constexpr int kLongPath = 100;
// Marching either repeats its contacts soon, or follows a motion that is not periodic.
constexpr int kMarchedPeriods = 300;

int bounded_pivots(int per_unknown, const HatProblem& problem) {
  const long unknowns = problem.form.lcp.matrix->size();
  return static_cast<int>(std::min<long>(per_unknown * unknowns, std::numeric_limits<int>::max()));
}

/// Attempts 1 and 2, or the solver asked for, with that many pivots or steps.
LcpResult follow_path(const HatProblem& problem, int max_iterations, const Start& start,
                      const Eigen::VectorXd& guess) {
  const HatSettings& settings = problem.settings;
  return solve_lcp(problem.form.lcp,
                   {.solver = settings.solver,
                    .tolerance = settings.tolerance,
                    .max_iterations = max_iterations,
                    .deadline = start.deadline,
                    .cover_amplitude = settings.cover_amplitude,
                    .cover_phase = settings.cover_phase},
                   guess);
}

/// Attempt 3; nothing where no periodic contact is found or Newton's method fails from it.
std::optional<LcpResult> march(const HatProblem& problem, const Start& start) {
  const Eigen::VectorXd pressure = march_to_period(
      problem.scene, problem.settings, problem.stops.restitution.value_or(0.0), kMarchedPeriods, start);
  if (pressure.size() == 0) return std::nullopt;
  LcpResult result = solve_by_newton(problem.form.lcp, {.tolerance = problem.settings.tolerance,
                                                        .guess = problem.form.scaled(pressure),
                                                        .deadline = start.deadline});
  if (result.status != LcpStatus::solved) return std::nullopt;
  return result;
}

}  // namespace

LcpResult solve_hat_problem(const HatProblem& problem, const Start& start) {
  const int asked = problem.settings.max_iterations;  // 0: not limited
  const Eigen::VectorXd guess =
      start.guess ? pressure_samples(*start.guess, problem.settings.samples, problem.form.unit)
                  : Eigen::VectorXd{};
  if (problem.settings.solver != ComplementaritySolver::automatic)
    return follow_path(problem, asked, start, guess);

  const int short_path = bounded_pivots(kShortPath, problem);
  const bool within_limit = asked > 0 && asked <= short_path;
  const LcpResult first = follow_path(problem, within_limit ? asked : short_path, start, guess);
  if (first.status != LcpStatus::limit || within_limit) return first;

  LcpResult result;
  if (std::optional<LcpResult> marched = march(problem, start)) {
    result = *std::move(marched);
  } else {
    result = follow_path(problem, asked > 0 ? asked : bounded_pivots(kLongPath, problem), start, {});
  }
  result.pivots += first.pivots;
  return result;
}

}  // namespace signorini
