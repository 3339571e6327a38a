#include "methods/aft_hbm/aft_grid_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/complementarity/forms.hpp"
#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/solvers/complementarity_solver.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

constexpr int kNewtonSteps = 100;
// Cold, Newton converges at once or creeps (of the one-mass population it solves no scene): the
// homotopy takes over early.
constexpr int kColdSteps = 5;

class AftGridSolver final : public GridSolver {
 public:
  explicit AftGridSolver(const AftSettings& settings) : settings_(settings) {}

  [[nodiscard]] Work initial_counts() const override { return {.iterations = 0}; }

  [[nodiscard]] GridSolution solve(const ProjectedEquations& equations, int samples,
                                   const Eigen::MatrixXcd& previous, const Start& start,
                                   Work& work) const override {
    AftResidual residual(equations, samples);
    const bool cold = previous.size() == 0 && !start.guess;
    NewtonKrylovResult newton =
        newton_from(first_iterate(residual, equations, previous, start),
                    cold && settings_.homotopy ? kColdSteps : kNewtonSteps, residual, start, work);
    GridSolution solution{.message = newton.converged ? "Newton-Krylov" : "Newton-Krylov found no descent"};
    if (!newton.converged && settings_.homotopy && !is_spent(work))
      newton = from_homotopy(std::move(newton), residual, equations, start, work, solution.message);
    solution.solved = newton.converged;
    // Newton alone that has lost its way is not helped by more samples.
    solution.finer_may_help = (newton.converged || settings_.homotopy) && !start.expired();
    solution.lambda = residual.coefficients(newton.unknowns);
    solution.residual = newton.residual;
    solution.condition = newton.condition;
    return solution;
  }

 private:
  static Eigen::VectorXd first_iterate(const AftResidual& residual, const ProjectedEquations& equations,
                                       const Eigen::MatrixXcd& previous, const Start& start) {
    if (previous.size() > 0) return residual.unknowns_of(previous);
    if (start.guess)
      return residual.unknowns_of(force_spectrum(*start.guess, equations.receptance.harmonics()));
    return Eigen::VectorXd::Zero(residual.unknowns());
  }

  /// One run of Newton's method. The equations are piecewise linear: near a solution one full step ends it.
  [[nodiscard]] NewtonKrylovResult newton_from(Eigen::VectorXd lambda, int steps, AftResidual& residual,
                                               const Start& start, Work& work) const {
    const int allowed = settings_.max_iterations > 0 ? std::min(settings_.max_iterations, steps) : steps;
    NewtonKrylovResult newton =
        solve_newton_krylov(residual, std::move(lambda), settings_.tolerance,
                            {.max_steps = allowed, .max_halvings = 16, .deadline = start.deadline});
    count_iterations(newton.iterations, work);
    return newton;
  }

  /// Newton's method from the end of the gap homotopy, or `failed` where that has none.
  [[nodiscard]] NewtonKrylovResult from_homotopy(NewtonKrylovResult failed, AftResidual& residual,
                                                 const ProjectedEquations& equations, const Start& start,
                                                 Work& work, std::string& message) const {
    const auto& [receptance, gap, law] = equations;
    SolverSettings settings{.tolerance = settings_.tolerance, .deadline = start.deadline};
    if (settings_.max_iterations > 0)
      settings.max_iterations = settings_.max_iterations - static_cast<int>(steps_spent(work));
    Lcp lcp = projected_lcp(receptance, gap, law, residual.samples());
    const LcpResult path = solve_lcp(lcp, settings);
    work.pivots = work.pivots.value_or(0) + path.pivots;
    message = fmt::format("gap homotopy: {}", describe(path.status));
    if (path.status != LcpStatus::solved) return failed;
    const Eigen::MatrixXcd lambda =
        force_coefficients(law, path.z, residual.samples(), receptance.harmonics());
    NewtonKrylovResult newton =
        newton_from(residual.unknowns_of(lambda), kNewtonSteps, residual, start, work);
    if (!newton.condition) newton.condition = path.condition;  // no step was needed
    message = "gap homotopy and Newton-Krylov";
    return newton;
  }

  [[nodiscard]] bool is_spent(const Work& work) const {
    return settings_.max_iterations > 0 && steps_spent(work) >= settings_.max_iterations;
  }

  AftSettings settings_;
};

}  // namespace

std::unique_ptr<GridSolver> aft_grid_solver(const AftSettings& settings) {
  return std::make_unique<AftGridSolver>(settings);
}

}  // namespace signorini
