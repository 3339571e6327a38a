#include "methods/harmonic_balance/grid_solver.hpp"

#include <algorithm>

#include "methods/complementarity/forms.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/mean_balance.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

SolverSettings remaining(SolverSettings settings, const Start& start, const Work& work) {
  settings.deadline = start.deadline;
  if (settings.max_iterations > 0)
    settings.max_iterations = static_cast<int>(std::max(1L, settings.max_iterations - steps_spent(work)));
  return settings;
}

Eigen::MatrixXcd first_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& previous,
                             const Start& start) {
  if (previous.size() > 0) return previous;
  if (start.guess) return carried_spectrum(receptance, *start.guess);
  return Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
}

GridSolver lcp_grid_solver(const SolverSettings& settings) {
  return [settings](const ProjectedEquations& equations, int samples, const Eigen::MatrixXcd& previous,
                    const Start& start, Work& work) -> GridSolution {
    const auto& [receptance, gap, law] = equations;
    const bool newton = settings.solver == ComplementaritySolver::newton;
    const Lcp lcp = projected_lcp(receptance, gap, law, samples);
    const SolverSettings left = remaining(settings, start, work);
    const auto guess = [&]() -> Eigen::VectorXd {
      if (!start.guess) return {};
      return pressure_samples(*start.guess, samples, equations.law.constant.cwiseSqrt());
    };
    const LcpResult result =
        newton && previous.size() > 0
            ? solve_by_newton_from(lcp, left, augmented_multiplier(equations, previous, samples))
            : solve_lcp(lcp, left, guess());
    work.unknowns = lcp.matrix->size();
    add_effort(newton ? Work{.iterations = result.iterations, .factorisations = result.factorisations}
                      : Work{.pivots = result.pivots},
               work);
    const bool solved = result.status == LcpStatus::solved;
    return {.solved = solved,
            // More samples repair a ray or a coarse quadrature, not a Newton iteration that has lost its way.
            .finer_may_help = (solved || !newton) && result.status != LcpStatus::interrupted,
            .lambda = carried_coefficients(equations, lcp, result.z),
            .residual = result.residual,
            .condition = result.condition,
            .message = describe(result.status)};
  };
}

void validate(const HarmonicOptions& options, ComplementaritySolver solver) {
  validate(options);
  require_option(options.continuation == Continuation::none || solver != ComplementaritySolver::pivoting,
                 "continuation", options.continuation, "must be none where solver = pivoting");
}

SolverSettings lcp_settings(const HarmonicOptions& options, ComplementaritySolver solver) {
  const bool papers = options.plain && solver == ComplementaritySolver::automatic;
  return {.solver = papers ? ComplementaritySolver::newton : solver,
          .tolerance = options.tolerance,
          .max_iterations = options.max_iterations};
}

}  // namespace signorini
