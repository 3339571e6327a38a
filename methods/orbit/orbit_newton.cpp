#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <utility>

#include "methods/orbit/orbit_equations.hpp"
#include "methods/solvers/damped_newton.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

// The equations of an orbit as damped_newton sees them, evaluated at the guess.
class NewtonOnOrbit {
 public:
  NewtonOnOrbit(OrbitEquations& equations, double tolerance, const std::function<bool()>& expired)
      : equations_(equations),
        tolerance_(tolerance),
        expired_(expired),
        unknowns_(equations.guess()),
        residual_(norm()) {}

  // From here on a residual counts as solved only if it is zero.
  void refine() {
    refining_ = true;
    slow_steps_ = 0;
  }
  // After a step that was not taken, the equations are at a trial.
  void return_to_iterate() { equations_.evaluate(unknowns_); }

  [[nodiscard]] double accepted() const { return std::max(tolerance_, equations_.noise()); }
  [[nodiscard]] bool solved() const {
    return !refining_ && residual_ <= accepted() && equations_.jacobian().allFinite();
  }
  [[nodiscard]] double merit() const { return residual_; }
  std::optional<double> find_step() {
    interrupted_ = expired_ && expired_();
    if (interrupted_) return std::nullopt;
    lu_.compute(equations_.jacobian());
    step_ = -lu_.solve(equations_.residual());
    if (const auto family = family_inverse(equations_, lu_.reciprocal_condition()))
      step_ = -(family->inverse * equations_.residual());
    if (!step_.allFinite()) return std::nullopt;
    const double longest = longest_part();
    short_steps_ = longest < kMerging ? short_steps_ + 1 : 0;
    slow_steps_ = residual_ <= 0.5 * halved_ ? 0 : slow_steps_ + 1;
    if (slow_steps_ == 0) halved_ = residual_;
    tried_ = false;
    return merging() || slow() ? std::nullopt : std::optional(longest);
  }
  // The first trial is mostly taken, and so is evaluated with its Jacobian; shorter ones are without.
  std::optional<double> merit_at(double length) {
    trial_ = unknowns_ + length * step_;
    differentiated_ = !std::exchange(tried_, true);
    const bool finite = differentiated_ ? equations_.evaluate(trial_) : equations_.evaluate_residual(trial_);
    return finite ? std::optional(norm()) : std::nullopt;
  }
  void accept() {
    unknowns_ = trial_;
    residual_ = norm();
    if (!differentiated_) static_cast<void>(equations_.evaluate(unknowns_));  // if not finite, so is the step
  }

  [[nodiscard]] bool interrupted() const { return interrupted_; }
  [[nodiscard]] bool merging() const { return short_steps_ >= kPatience; }
  [[nodiscard]] bool slow() const { return slow_steps_ > kSlowest; }
  [[nodiscard]] const Eigen::VectorXd& unknowns() const { return unknowns_; }

 private:
  static constexpr double kMerging = 1e-3;  // part of a step that an interval about to vanish leaves of it
  static constexpr int kPatience = 3;       // such steps in a row
  static constexpr int kSlowest = 10;       // steps to halve the residual: of a wrong sequence they are many

  [[nodiscard]] double norm() const { return equations_.residual().lpNorm<Eigen::Infinity>(); }

  // The part of the step that leaves each interval between events a fifth of its length: in the unknowns
  // s = omega (t - t_0) the interval s_i - s_k loses part (step_k - step_i). An event that may overtake those
  // before it is held back by the last one that it may not.
  [[nodiscard]] double longest_part() const {
    constexpr double kKept = 0.2, kOvertakes = 0.05;
    double part = 1.0;
    const Eigen::Index m = equations_.events(), first = equations_.size() - m;
    for (Eigen::Index i = 0; i <= m; ++i) {
      const double at = i == m ? equations_.end() : unknowns_[first + i];
      const double move = i == m ? 0.0 : step_[first + i];
      for (Eigen::Index k = i - 1; k >= -1; --k) {
        const double shrinks = (k < 0 ? 0.0 : step_[first + k]) - move;
        double length = at - (k < 0 ? 0.0 : unknowns_[first + k]);
        const bool passes = k >= 0 && i < m && length < kOvertakes && equations_.may_overtake(i, k);
        if (passes) length = std::max(0.0, length + kOvertakes);
        if (shrinks > 0.0 && part * shrinks > (1.0 - kKept) * length)
          part = std::max(0.0, (1.0 - kKept) * length / shrinks);
        if (!passes) break;
      }
    }
    return part;
  }

  OrbitEquations& equations_;
  double tolerance_;
  const std::function<bool()>& expired_;
  Eigen::VectorXd unknowns_, trial_, step_;
  double residual_;
  LuFactors lu_;
  int short_steps_ = 0;
  double halved_ = residual_;    // the residual when it was halved last,
  int slow_steps_ = 0;           // and the steps since
  bool tried_ = false;           // a length of the present step
  bool differentiated_ = false;  // the last trial
  bool refining_ = false;
  bool interrupted_ = false;
};

// Why the first search failed; empty where its residual is round-off all the same.
std::string failure(const NewtonOnOrbit& newton, const DampedNewtonResult& search, double noise) {
  const double residual = newton.merit();
  if (newton.interrupted()) return "the time is up";
  const bool round_off = residual <= std::max(newton.accepted(), kNoiseMargin * noise);
  if (newton.merging()) return fmt::format("the steps close an interval (residual {:.2g})", residual);
  if (round_off && (newton.slow() || search.end == NewtonEnd::stalled)) return {};
  if (newton.slow()) return fmt::format("the residual falls slowly (residual {:.2g})", residual);
  switch (search.end) {
    case NewtonEnd::singular:
      return "the equations are singular (a multiplier is 1, or an impact grazes)";
    case NewtonEnd::stalled:
      return fmt::format("no descent along the Newton step (residual {:.2g})", residual);
    default:
      return fmt::format("no convergence in {} Newton steps (residual {:.2g})", search.steps, residual);
  }
}

}  // namespace

OrbitNewtonResult solve(OrbitEquations& equations, double tolerance, int max_iterations,
                        const std::function<bool()>& expired) {
  constexpr DampedNewtonLimits kStep{.max_steps = 1, .max_halvings = 0, .sufficient_decrease = 0.1};
  OrbitNewtonResult result;
  result.unknowns = equations.guess();
  if (!equations.evaluate(result.unknowns)) {
    result.reason = "the flow is not finite";
    return result;
  }
  NewtonOnOrbit newton(equations, tolerance, expired);
  const DampedNewtonResult search =
      damped_newton(newton, {.max_steps = max_iterations, .max_halvings = 11, .sufficient_decrease = 0.1});
  result.iterations = search.steps;
  if (search.end == NewtonEnd::stalled) newton.return_to_iterate();
  if (search.end != NewtonEnd::solved) {
    result.merging = newton.merging();
    result.reason = failure(newton, search, equations.noise());
    result.solved = result.reason.empty();
  } else {
    result.solved = true;
    newton.refine();
    const DampedNewtonResult refined =
        search.steps < max_iterations ? damped_newton(newton, kStep) : DampedNewtonResult{};
    result.iterations += refined.steps;
    if (refined.end == NewtonEnd::stalled) newton.return_to_iterate();
  }
  result.residual = newton.merit();
  result.unknowns = newton.unknowns();
  return result;
}

}  // namespace signorini
