#pragma once
// Newton's method for equations that are known by their values and by linear solves with their Jacobian, and
// GMRES, without restart, for operators known only by their product.

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/damped_newton.hpp"

namespace signorini {

/// Tolerance of GMRES in a Newton step, relative to the right-hand side [-].
inline constexpr double kKrylovTolerance = 1e-12;
/// Unknowns up to which a Newton step is solved by factors where GMRES fails: 128 MB, some seconds.
inline constexpr Eigen::Index kMostByFactors = 4000;

/// The end of a linear solve.
struct KrylovSolve {
  Eigen::VectorXd x;  ///< empty where the tolerance was missed or a number is not finite
  /// Of A M^{-1}, estimated from the Krylov space: a lower bound; empty: no system was solved [-]
  std::optional<double> condition = 1.0;
};

/// Solves A x = b from x = 0 by right-preconditioned GMRES, modified Gram-Schmidt and one
/// reorthogonalisation, until |b - A x|_2 <= tolerance |b|_2 or the Krylov space has the full size of b, or
/// `most` vectors.
/// Right preconditioning keeps the residual that of the system itself.
/// \param product       v -> A v, an Eigen::VectorXd
/// \param precondition  v -> M^{-1} v, likewise
/// Source: [saad1986].
template <class Product, class Precondition>
KrylovSolve solve_by_gmres(const Product& product, const Precondition& precondition, const Eigen::VectorXd& b,
                           double tolerance, Eigen::Index most = std::numeric_limits<Eigen::Index>::max()) {
  const double norm = b.norm();
  if (!std::isfinite(norm)) return {};
  if (norm == 0.0) return {.x = Eigen::VectorXd::Zero(b.size())};
  const Eigen::Index size = b.size();
  std::vector<Eigen::VectorXd> basis{b / norm};
  std::vector<Eigen::VectorXd> columns;  // of R, after the rotations
  std::vector<Eigen::JacobiRotation<double>> rotations;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(size + 1);
  rhs[0] = norm;
  Eigen::Index used = 0;
  while (used < std::min(size, most) && std::abs(rhs[used]) > tolerance * norm) {
    // Arnoldi's step, A M^{-1} V_k = V_{k+1} H_k. The second pass restores the orthogonality that
    // cancellation in the first one costs; without it the residual below is no longer that of the recurrence.
    Eigen::VectorXd next = product(precondition(basis.back()));
    Eigen::VectorXd column = Eigen::VectorXd::Zero(used + 2);
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index k = 0; k <= used; ++k) {
        const double component = basis[static_cast<std::size_t>(k)].dot(next);
        column[k] += component;
        next -= component * basis[static_cast<std::size_t>(k)];
      }
    }
    const double rest = next.norm();
    column[used + 1] = rest;
    if (!std::isfinite(rest)) return {};
    // H_k = Q R by one new rotation; the last entry of Q^T |b| e_1 is the norm of the residual, without
    // forming it.
    for (Eigen::Index k = 0; k < used; ++k) {
      column.applyOnTheLeft(k, k + 1, rotations[static_cast<std::size_t>(k)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[used], column[used + 1]);
    column.applyOnTheLeft(used, used + 1, rotation.adjoint());
    rhs.applyOnTheLeft(used, used + 1, rotation.adjoint());
    rotations.push_back(rotation);
    columns.push_back(column);
    ++used;
    if (rest == 0.0) break;  // the Krylov space is exhausted: the solution lies in it
    basis.emplace_back(next / rest);
  }
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(used, used);
  Eigen::VectorXd weights = rhs.head(used);
  Eigen::VectorXd combination = Eigen::VectorXd::Zero(size);
  for (Eigen::Index k = used - 1; k >= 0; --k) {
    const Eigen::VectorXd& column = columns[static_cast<std::size_t>(k)];
    triangle.col(k).head(k + 1) = column.head(k + 1);
    weights[k] /= column[k];
    weights.head(k) -= weights[k] * column.head(k);
    combination += weights[k] * basis[static_cast<std::size_t>(k)];
  }
  KrylovSolve solve{.x = precondition(combination), .condition = triangular_condition(triangle)};
  // The recurrence may promise more than rounding keeps; the true residual decides.
  const double residual = (b - product(solve.x)).norm();
  if (!(residual <= std::max(10.0 * tolerance, 1e-8) * norm)) return {};
  return solve;
}

/// R(v) = 0 in n unknowns.
template <class System>
concept JacobianSystem = requires(System& system, const Eigen::VectorXd& v) {
  // R(v), n. Later solves belong to the Jacobian J at this v.
  { system.residual(v) } -> std::convertible_to<Eigen::VectorXd>;
  // J^{-1} r, usually by GMRES; x is empty where it failed.
  { system.solve_jacobian(v) } -> std::same_as<KrylovSolve>;
  // How far v is from being solved, of v and R(v): a relative residual, to fall below the tolerance.
  { system.error(v, v) } -> std::convertible_to<double>;
};

/// The end of Newton's method.
struct NewtonKrylovResult {
  NewtonEnd end = NewtonEnd::limit;  ///< why it ended; solved: residual <= tolerance
  int iterations = 0;                ///< Newton steps
  double residual = 0.0;             ///< the system's error of the last iterate accepted
  Eigen::VectorXd unknowns = {};     ///< v, the last iterate accepted
  /// Estimate for the Jacobian of the last step; empty: none taken [-].
  std::optional<double> condition = {};
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

  /// Whether the system's error is below the tolerance.
  [[nodiscard]] bool solved() {
    result_.residual = system_.error(result_.unknowns, value_);
    return result_.residual <= tolerance_;
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

/// Solves R(v) = 0 from `v` until the system's error is at most `tolerance`, by Newton's method with step
/// halving on |R|_2 (damped_newton). Source: [kelley1995, chapter 8].
template <JacobianSystem System>
NewtonKrylovResult solve_newton_krylov(System& system, Eigen::VectorXd v, double tolerance,
                                       const DampedNewtonLimits& limits) {
  NewtonKrylovEquations<System> equations(system, std::move(v), tolerance);
  const DampedNewtonResult newton = damped_newton(equations, limits);
  equations.result().end = newton.end;
  equations.result().iterations = newton.steps;
  return std::move(equations.result());
}

}  // namespace signorini
