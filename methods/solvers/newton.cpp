#include "methods/solvers/newton.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <vector>

#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/damped_newton.hpp"

namespace signorini {

namespace {

/// F(y) = max(0, -y) - q - A max(0, y) as damped_newton sees it.
class NormalMap {
 public:
  NormalMap(const Lcp& lcp, Eigen::VectorXd y, double tolerance)
      : lcp_(lcp), tolerance_(tolerance), y_(std::move(y)), value_(at(y_)) {}

  /// Both the complementarity residual of z = max(0, y) and F itself must be small: F = 0 alone is relative
  /// to y, which may be far larger than z where contact is loose.
  [[nodiscard]] bool solved() {
    answer_.z = y_.cwiseMax(0.0);
    answer_.residual = natural_residual(lcp_, answer_.z);
    const double scale = std::max(lcp_.offset.lpNorm<Eigen::Infinity>(), y_.lpNorm<Eigen::Infinity>());
    return answer_.residual <= tolerance_ && value_.lpNorm<Eigen::Infinity>() <= tolerance_ * scale;
  }

  [[nodiscard]] double merit() const { return value_.norm(); }

  [[nodiscard]] std::optional<double> find_step() {
    target_ = linear_solution();
    ++answer_.factorisations;
    return target_.size() > 0 ? std::optional(1.0) : std::nullopt;
  }

  [[nodiscard]] double merit_at(double length) {
    trial_ = y_ + length * (target_ - y_);
    trial_value_ = at(trial_);
    return trial_value_.norm();
  }

  void accept() {
    y_.swap(trial_);
    value_.swap(trial_value_);
  }

  /// The complementarity problem's answer as of the last question for it, its status still open.
  [[nodiscard]] LcpResult& answer() { return answer_; }

 private:
  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& y) const {
    return (-y).cwiseMax(0.0) - lcp_.offset - *lcp_.matrix * y.cwiseMax(0.0);
  }

  /// y + s. With the active set S = {y > 0} frozen, F is linear and its zero is A_SS z_S = -q_S, y = z on S
  /// and y = -w = -(q + A z) off it. Empty where A_SS is singular.
  [[nodiscard]] Eigen::VectorXd linear_solution() {
    std::vector<int> active;
    for (int i = 0; i < static_cast<int>(y_.size()); ++i) {
      if (y_[i] > 0.0) active.push_back(i);
    }
    answer_.condition.reset();
    if (active.empty()) return -lcp_.offset;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(lcp_.matrix->submatrix(active, active));
    const Eigen::VectorXd held = lu.solve(Eigen::VectorXd(-lcp_.offset(active)));
    if (!held.allFinite()) return {};
    answer_.condition = condition_from(lu.rcond());
    Eigen::VectorXd z = Eigen::VectorXd::Zero(y_.size());
    z(active) = held;
    Eigen::VectorXd solution = -(lcp_.offset + *lcp_.matrix * z);
    solution(active) = held;
    return solution;
  }

  const Lcp& lcp_;
  double tolerance_;
  LcpResult answer_;
  Eigen::VectorXd y_;
  Eigen::VectorXd value_;  // F(y)
  Eigen::VectorXd target_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd trial_value_;
};

LcpStatus status_of(NewtonEnd end) {
  switch (end) {
    case NewtonEnd::solved:
      return LcpStatus::solved;
    case NewtonEnd::limit:
      return LcpStatus::limit;
    case NewtonEnd::interrupted:
      return LcpStatus::interrupted;
    case NewtonEnd::singular:
      return LcpStatus::breakdown;
    case NewtonEnd::stalled:
      return LcpStatus::stalled;
  }
  return LcpStatus::breakdown;
}

/// Where the guess presses, y = z; elsewhere y = -w. Without a guess the contact-free response, z = 0.
Eigen::VectorXd first_iterate(const Lcp& lcp, const Eigen::VectorXd& guess) {
  if (guess.size() != lcp.offset.size()) return -lcp.offset;
  return (guess.array() > 0.0).select(guess, -(lcp.offset + *lcp.matrix * guess));
}

}  // namespace

LcpResult solve_by_newton(const Lcp& lcp, const NewtonOptions& options) {
  NormalMap equations(lcp, first_iterate(lcp, options.guess), options.tolerance);
  const DampedNewtonResult newton = damped_newton(
      equations, {.max_steps = options.max_iterations, .max_halvings = 20, .deadline = options.deadline});
  LcpResult result = std::move(equations.answer());
  result.status = status_of(newton.end);
  result.iterations = newton.steps;
  return result;
}

}  // namespace signorini
