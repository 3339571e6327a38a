#include "methods/aft_hbm/aft_grid_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "methods/complementarity/forms.hpp"
#include "methods/complementarity/projected_residual.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

namespace {

// Cold, Newton converges at once or creeps (of the one-mass population it solves no scene): the
// homotopy takes over early.
constexpr int kColdSteps = 5;

/// One run of Newton's method. The equations are piecewise linear: near a solution one full step ends it.
NewtonKrylovResult newton_from(const Eigen::MatrixXcd& force, int steps, const SolverSettings& settings,
                               ProjectedResidual& residual, const Start& start, Work& work) {
  const int allowed = settings.max_iterations > 0 ? std::min(settings.max_iterations, steps) : steps;
  NewtonKrylovResult newton =
      solve_newton_krylov(residual, residual.unknowns_of(force), settings.tolerance,
                          {.max_steps = allowed, .max_halvings = 16, .deadline = start.deadline});
  count_iterations(newton.iterations, work);
  return newton;
}

/// Newton's method from the end of the gap homotopy; `newton` stays as it is where that has none. \return how
/// it went
std::string follow_homotopy(NewtonKrylovResult& newton, const ProjectedEquations& equations,
                            const SolverSettings& settings, ProjectedResidual& residual, const Start& start,
                            Work& work) {
  const auto& [receptance, gap, law] = equations;
  const Lcp lcp = projected_lcp(receptance, gap, law, residual.samples());
  const LcpResult path = solve_lcp(lcp, remaining(settings, start, work));
  work.pivots = work.pivots.value_or(0) + path.pivots;
  if (path.status != LcpStatus::solved) return fmt::format("gap homotopy: {}", describe(path.status));
  const Eigen::MatrixXcd force = carried_coefficients(equations, lcp, path.z);
  newton = newton_from(force, DampedNewtonLimits{}.max_steps, settings, residual, start, work);
  if (!newton.condition) newton.condition = path.condition;  // no step was needed
  return "gap homotopy and Newton-Krylov";
}

}  // namespace

GridSolver aft_grid_solver(const SolverSettings& settings, bool homotopy) {
  return
      [settings, homotopy](const ProjectedEquations& equations, int samples, const Eigen::MatrixXcd& previous,
                           const Start& start, Work& work) -> GridSolution {
        ProjectedResidual residual(equations, samples, settings.tolerance, {}, ContactIntegral::sampled);
        const bool cold = previous.size() == 0 && !start.guess;
        const int steps = cold && homotopy ? kColdSteps : DampedNewtonLimits{}.max_steps;
        NewtonKrylovResult newton = newton_from(first_force(equations.receptance, previous, start), steps,
                                                settings, residual, start, work);
        const auto converged = [&] { return newton.end == NewtonEnd::solved; };
        std::string message = converged() ? "Newton-Krylov" : "Newton-Krylov found no descent";
        if (!converged() && homotopy && !is_spent(settings.max_iterations, work))
          message = follow_homotopy(newton, equations, settings, residual, start, work);
        return {.solved = converged(),
                // Newton alone that has lost its way is not helped by more samples.
                .finer_may_help = (converged() || homotopy) && !start.expired(),
                .lambda = residual.force_of(newton.unknowns),
                .residual = newton.residual,
                .condition = newton.condition,
                .message = std::move(message)};
      };
}

}  // namespace signorini
