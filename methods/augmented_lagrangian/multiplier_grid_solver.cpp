#include "methods/augmented_lagrangian/multiplier_grid_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_residual.hpp"
#include "methods/solvers/anderson_acceleration.hpp"
#include "methods/solvers/homotopy.hpp"
#include "methods/structure/mean_balance.hpp"

namespace signorini {

namespace {

/// One solve on a grid.
class MultiplierIteration {
 public:
  MultiplierIteration(const ProjectedEquations& equations, const ExactProjectionSettings& settings,
                      Eigen::MatrixXcd lambda, bool accelerated)
      : equations_(equations),
        settings_(settings),
        lipschitz_(equations, settings.samples, settings.tolerance),
        depth_(accelerated ? 8 : 0),
        acceleration_(depth_),
        lambda_(std::move(lambda)) {}

  [[nodiscard]] const Eigen::MatrixXcd& lambda() const { return lambda_; }
  [[nodiscard]] const std::optional<double>& condition() const { return condition_; }
  [[nodiscard]] int newton_steps() const { return newton_steps_; }
  [[nodiscard]] long pivots() const { return pivots_; }

  /// Of the projected equations at lambda.
  [[nodiscard]] double residual() {
    const Eigen::VectorXd packed = lipschitz_.unknowns_of(lambda_);
    return lipschitz_.error(packed, lipschitz_.residual(packed));
  }

  /// Solves the penalty rho with mu = 0: through rising penalties or, with pivots, from a penalty of the size
  /// of the highest dynamic stiffness. False where no way leads there.
  bool begin(bool by_pivoting, const Start& start) {
    constexpr double kPivoted = 1.0 / kAugmentedMultiple;  // of rho: long contacts, which a grid resolves
    return by_pivoting ? pivot(kPivoted, start) && harden(kPivoted) : rise();
  }

  /// Solves the penalty rho with mu = 0 through rising penalties, from the present lambda.
  bool rise() {
    multiplier_.resize(0, 0);
    acceleration_ = AndersonAcceleration(depth_);
    // Of rho where a penalty is soft beside the structure at the frequency of the motion.
    constexpr double kSoft = 0.1;
    const Eigen::VectorXd compliance = equations_.receptance.receptance[1].diagonal().cwiseAbs();
    const double first = std::min(1.0, kSoft / compliance.cwiseProduct(equations_.law.constant).maxCoeff());
    return solve(equations_.receptance, first) && harden(first);
  }

  /// One update of the multiplier, to lambda or, accelerated, beyond it; less far where Newton's method does
  /// not follow. False where it follows nowhere.
  bool update() {
    const int halvings = depth_ > 0 ? 6 : 0;
    if (multiplier_.size() == 0) multiplier_ = Eigen::MatrixXcd::Zero(lambda_.rows(), lambda_.cols());
    const Eigen::MatrixXcd before = multiplier_;
    const Eigen::MatrixXcd next = lipschitz_.force_of(
        acceleration_.next(lipschitz_.unknowns_of(multiplier_), lipschitz_.unknowns_of(lambda_)));
    double part = 1.0;
    for (int k = 0; k <= halvings; ++k, part *= 0.5) {
      multiplier_ = before + part * (next - before);
      if (solve(held_by(multiplier_), 1.0)) return true;
    }
    return false;
  }

 private:
  /// A share of rho by pivoting on samples, as penalty-hbm begins.
  bool pivot(double share, const Start& start) {
    const ProjectedLaw law = penalty(share);
    Work work;
    const GridSolution solved = lcp_grid_solver({.tolerance = settings_.tolerance})(
        {equations_.receptance, equations_.gap, law}, settings_.samples, {}, start, work);
    pivots_ += work.pivots.value_or(0);
    if (!solved.solved) return false;
    lambda_ = solved.lambda;
    return solve(equations_.receptance, share);
  }

  /// From a solved share of rho up to rho, each penalty from the solution of the one before, the next one
  /// nearer where Newton's method does not follow.
  bool harden(double solved) {
    constexpr PathSteps kSteps{.smallest = 0.03};  // in log2 rho: penalties at most double
    const auto advance = [&](double step) {
      const double share = std::min(1.0, solved * std::exp2(step));
      const bool follows = solve(equations_.receptance, share);
      if (follows) solved = share;
      return follows;
    };
    return follow_path(
        kSteps, advance, [&] { return solved >= 1.0; }, [] { return false; });
  }

  /// rho (x - g) - alpha mu = rho (x - alpha mu / rho - g): a multiplier is a part of the free response.
  [[nodiscard]] ContactReceptance held_by(const Eigen::MatrixXcd& multiplier) const {
    const ProjectedLaw& law = equations_.law;
    const Eigen::VectorXd weight = law.multiplier_weight.cwiseQuotient(law.constant);
    ContactReceptance moved = equations_.receptance;
    moved.free_response -= balanced_force(equations_.receptance, multiplier) * weight.asDiagonal();
    return moved;
  }

  [[nodiscard]] ProjectedLaw penalty(double share) const {
    return {.constant = share * equations_.law.constant,
            .multiplier_weight = Eigen::VectorXd::Zero(lambda_.cols())};
  }

  /// The penalty law with a share of rho, from the present lambda.
  bool solve(const ContactReceptance& receptance, double share) {
    const ProjectedLaw law = penalty(share);
    ExactProjection solved = project_exactly({receptance, equations_.gap, law}, lambda_, settings_);
    newton_steps_ += solved.iterations;
    if (solved.condition) condition_ = solved.condition;
    if (!solved.converged) return false;
    lambda_ = std::move(solved.lambda);
    return true;
  }

  const ProjectedEquations& equations_;
  ExactProjectionSettings settings_;
  ProjectedResidual lipschitz_;
  int depth_;  // of the acceleration; 0: none
  AndersonAcceleration acceleration_;
  Eigen::MatrixXcd lambda_;      // (H+1) x Nc [N]
  Eigen::MatrixXcd multiplier_;  // mu behind lambda, of the same size; empty: none yet
  std::optional<double> condition_;
  int newton_steps_ = 0;
  long pivots_ = 0;
};

/// What the updates ask of a solve.
struct UpdateLimits {
  double tolerance = 0.0;  // on the residual [-]
  int updates = 0;
  int newton_steps = 0;  // 0: not limited

  [[nodiscard]] bool permit_more_steps(const MultiplierIteration& iteration) const {
    return newton_steps == 0 || iteration.newton_steps() < newton_steps;
  }
};

/// Updates the multiplier until the residual is accepted, or a limit is met, or it leads away; residual and
/// message into `solution`. False where Newton's method does not follow.
bool iterate(MultiplierIteration& iteration, const UpdateLimits& limits, const char* origin,
             GridSolution& solution) {
  constexpr double kGrown = 1e3;  // an error that grows by a factor takes few updates to get there
  bool follows = true;
  int updates = 0;
  double residual = iteration.residual(), least = residual, factor = 0.0;
  const char* end = "solved";
  while (!(residual <= limits.tolerance)) {
    if (!std::isfinite(residual) || residual > kGrown * least) {
      end = "divergence";
    } else if (updates >= limits.updates || !limits.permit_more_steps(iteration)) {
      end = "not converged";
    } else if (follows = iteration.update(); !follows) {
      end = "Newton's method does not follow";
    } else {
      const double before = std::exchange(residual, iteration.residual());
      factor = residual / before;
      least = std::min(least, residual);
      ++updates;
      continue;
    }
    break;
  }
  solution.residual = residual;
  const std::string last =
      updates > 0 ? fmt::format(", residual times {:.2g} in the last", factor) : std::string();
  solution.message = fmt::format("{} after {} updates of the multiplier{}{}", end, updates, last, origin);
  return follows;
}

}  // namespace

GridSolver multiplier_grid_solver(const SolverSettings& settings, int updates, bool plain) {
  const UpdateLimits limits{settings.tolerance, updates, settings.max_iterations};
  return [limits, plain](const ProjectedEquations& equations, int samples, const Eigen::MatrixXcd& previous,
                         const Start& start, Work& work) {
    const bool cold = previous.size() == 0 && !start.guess;
    MultiplierIteration iteration(
        equations, {.samples = samples, .tolerance = limits.tolerance, .deadline = start.deadline},
        first_force(equations.receptance, previous, start), !plain);
    GridSolution solution{.finer_may_help = !plain && !start.expired()};
    bool begun = !cold || iteration.begin(!plain, start);
    if (begun && !iterate(iteration, limits, "", solution) && !cold && !plain &&
        limits.permit_more_steps(iteration)) {
      // As a multiplier the force given is too far away for Newton's method.
      begun = iteration.rise();
      if (begun) iterate(iteration, limits, ", from soft penalties", solution);
    }
    if (!begun) {
      solution.message = "no solution of the penalty";
      solution.residual = iteration.residual();
    }
    solution.solved = solution.residual <= limits.tolerance;
    solution.lambda = iteration.lambda();
    solution.condition = iteration.condition();
    count_iterations(iteration.newton_steps(), work);
    if (!plain) work.pivots = work.pivots.value_or(0) + iteration.pivots();
    return solution;
  };
}

}  // namespace signorini
