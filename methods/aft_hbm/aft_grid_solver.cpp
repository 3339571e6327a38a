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

class AftGridSolver final : public GridSolver {
 public:
  AftGridSolver(const SolverSettings& settings, bool homotopy) : settings_(settings), homotopy_(homotopy) {}

  [[nodiscard]] Work initial_counts() const override { return {.iterations = 0}; }

  [[nodiscard]] GridSolution solve(const ProjectedEquations& equations, int samples,
                                   const Eigen::MatrixXcd& previous, const Start& start,
                                   Work& work) const override {
    ProjectedResidual residual(equations, samples, settings_.tolerance, {}, ContactIntegral::sampled);
    const bool cold = previous.size() == 0 && !start.guess;
    NewtonKrylovResult newton =
        newton_from(first_force(equations.receptance, previous, start),
                    cold && homotopy_ ? kColdSteps : DampedNewtonLimits{}.max_steps, residual, start, work);
    const auto converged = [&] { return newton.end == NewtonEnd::solved; };
    std::string message = converged() ? "Newton-Krylov" : "Newton-Krylov found no descent";
    if (!converged() && homotopy_ && !is_spent(settings_.max_iterations, work))
      newton = from_homotopy(std::move(newton), residual, equations, start, work, message);
    return {.solved = converged(),
            // Newton alone that has lost its way is not helped by more samples.
            .finer_may_help = (converged() || homotopy_) && !start.expired(),
            .lambda = residual.force_of(newton.unknowns),
            .residual = newton.residual,
            .condition = newton.condition,
            .message = std::move(message)};
  }

 private:
  /// One run of Newton's method. The equations are piecewise linear: near a solution one full step ends it.
  [[nodiscard]] NewtonKrylovResult newton_from(const Eigen::MatrixXcd& force, int steps,
                                               ProjectedResidual& residual, const Start& start,
                                               Work& work) const {
    const int allowed = settings_.max_iterations > 0 ? std::min(settings_.max_iterations, steps) : steps;
    NewtonKrylovResult newton =
        solve_newton_krylov(residual, residual.unknowns_of(force), settings_.tolerance,
                            {.max_steps = allowed, .max_halvings = 16, .deadline = start.deadline});
    count_iterations(newton.iterations, work);
    return newton;
  }

  /// Newton's method from the end of the gap homotopy, or `failed` where that has none.
  [[nodiscard]] NewtonKrylovResult from_homotopy(NewtonKrylovResult failed, ProjectedResidual& residual,
                                                 const ProjectedEquations& equations, const Start& start,
                                                 Work& work, std::string& message) const {
    const auto& [receptance, gap, law] = equations;
    const Lcp lcp = projected_lcp(receptance, gap, law, residual.samples());
    const LcpResult path = solve_lcp(lcp, remaining(settings_, start, work));
    work.pivots = work.pivots.value_or(0) + path.pivots;
    message = fmt::format("gap homotopy: {}", describe(path.status));
    if (path.status != LcpStatus::solved) return failed;
    const Eigen::MatrixXcd force = carried_coefficients(equations, lcp, path.z);
    NewtonKrylovResult newton = newton_from(force, DampedNewtonLimits{}.max_steps, residual, start, work);
    if (!newton.condition) newton.condition = path.condition;  // no step was needed
    message = "gap homotopy and Newton-Krylov";
    return newton;
  }

  SolverSettings settings_;
  bool homotopy_;
};

}  // namespace

std::unique_ptr<GridSolver> aft_grid_solver(const SolverSettings& settings, bool homotopy) {
  return std::make_unique<AftGridSolver>(settings, homotopy);
}

}  // namespace signorini
