#pragma once
// Newton's method for equations that are known by their values and by linear solves with their Jacobian.

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <utility>

#include "methods/solvers/damped_newton.hpp"
#include "methods/solvers/gmres.hpp"

namespace signorini {

/// R(v) = 0 in n unknowns.
template <class System>
concept JacobianSystem = requires(System& system, const Eigen::VectorXd& v) {
  // R(v), n. Later solves belong to the Jacobian J at this v.
  { system.residual(v) } -> std::convertible_to<Eigen::VectorXd>;
  // J^{-1} r, usually by GMRES; x is empty where it failed.
  { system.solve_jacobian(v) } -> std::same_as<KrylovSolve>;
  // What |R(v)|_2 is measured against, of v and R(v).
  { system.scale(v, v) } -> std::convertible_to<double>;
};

/// The end of Newton's method.
struct NewtonKrylovResult {
  bool converged = false;         ///< residual <= tolerance
  int iterations = 0;             ///< Newton steps
  double residual = 0.0;          ///< |R|_2 / scale, 0 where both vanish [-]
  Eigen::VectorXd unknowns = {};  ///< v, the last iterate accepted
  std::optional<double> condition =
      {};  ///< estimate for the Jacobian of the last step; empty: none taken [-]
};

/// A JacobianSystem as damped_newton sees it: the merit is |R|_2.
template <JacobianSystem System>
class NewtonKrylovEquations {
 public:
  /// At v; keeps a reference to the system.
  NewtonKrylovEquations(System& system, Eigen::VectorXd v, double tolerance)
      : system_(system), tolerance_(tolerance), value_(system.residual(v)) {
    result_.unknowns = std::move(v);
  }

  /// |R|_2 <= tolerance * scale.
  [[nodiscard]] bool solved() {
    const double scale = system_.scale(result_.unknowns, value_);
    result_.residual = scale > 0.0 ? value_.norm() / scale : 0.0;
    result_.converged = result_.residual <= tolerance_;
    return result_.converged;
  }

  /// |R|_2 at the iterate.
  [[nodiscard]] double merit() const { return value_.norm(); }

  /// The full step, or none where the linear solve failed.
  [[nodiscard]] std::optional<double> find_step() {
    KrylovSolve solve = system_.solve_jacobian(value_);
    if (solve.x.size() == 0 || !solve.x.allFinite()) return std::nullopt;
    result_.condition = solve.condition;
    correction_ = std::move(solve.x);  // J^{-1} R: the step is its negative
    return 1.0;
  }

  /// |R|_2 at a trial.
  [[nodiscard]] double merit_at(double length) {
    trial_ = result_.unknowns - length * correction_;
    trial_value_ = system_.residual(trial_);
    return trial_value_.norm();
  }

  /// Makes the last trial the iterate.
  void accept() {
    result_.unknowns.swap(trial_);
    value_.swap(trial_value_);
  }

  /// The answer as of the last question for it.
  [[nodiscard]] NewtonKrylovResult& result() { return result_; }

 private:
  System& system_;
  double tolerance_;
  NewtonKrylovResult result_;
  Eigen::VectorXd value_;  // R at the iterate
  Eigen::VectorXd correction_;
  Eigen::VectorXd trial_;
  Eigen::VectorXd trial_value_;
};

/// Solves R(v) = 0 from `v` until |R|_2 <= tolerance * scale, by Newton's method with step halving
/// (damped_newton). Source: [kelley1995, chapter 8].
template <JacobianSystem System>
NewtonKrylovResult solve_newton_krylov(System& system, Eigen::VectorXd v, double tolerance,
                                       const DampedNewtonLimits& limits) {
  NewtonKrylovEquations<System> equations(system, std::move(v), tolerance);
  const DampedNewtonResult newton = damped_newton(equations, limits);
  equations.result().iterations = newton.steps;
  return std::move(equations.result());
}

}  // namespace signorini
