#pragma once
// One step of pseudo-arclength continuation: tangent, corrector, step control, and a zero along the step.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

/// n equations R(x) = 0 in n + 1 unknowns, the parameter of the curve as the last one, in units in which
/// lengths along the curve mean something: the norm is Euclidean.
template <class Equations>
concept CurveEquations = requires(Equations& equations, const Eigen::VectorXd& x) {
  // n.
  { equations.size() } -> std::convertible_to<Eigen::Index>;
  // Takes x; false where R is not defined or not finite there.
  { equations.evaluate(x) } -> std::convertible_to<bool>;
  // R, n, where evaluated last.
  { equations.residual() } -> std::convertible_to<Eigen::VectorXd>;
  // [dR/dx], n x (n + 1), there.
  { equations.jacobian() } -> std::convertible_to<Eigen::MatrixXd>;
  // What rounding makes of R there.
  { equations.noise() } -> std::convertible_to<double>;
};

/// Equations that leave more than one direction free, as of motions that may begin at any phase, and of which
/// one follows from the others for each: they hold k conditions C (x - predicted) = 0 along a step besides.
template <class Equations>
concept HoldsConditions = requires(const Equations& equations) {
  // C, k x (n + 1), k = 0 included.
  { equations.conditions() } -> std::convertible_to<Eigen::MatrixXd>;
};

/// Equations of which some unknowns follow from the others so steeply that they are put in their places
/// before each evaluation of the corrector.
template <class Equations>
concept Settles = requires(Equations& equations, Eigen::VectorXd& x) {
  equations.settle(x);
};

/// When the corrector stops.
struct CorrectorLimits {
  int iterations = 7;        ///< Newton steps at most
  double tolerance = 2e-13;  ///< of R, relative to the largest unknown [-]
};

/// A point of the curve, and the Newton steps that led to it.
struct CorrectedPoint {
  Eigen::VectorXd x;
  int iterations = 0;
};

/// The matrix [R_x; row; C] of a step: n + 1 square, or higher where conditions are held.
template <CurveEquations Equations>
Eigen::MatrixXd bordered_jacobian(Equations& equations, const Eigen::VectorXd& row) {
  const Eigen::Index n = equations.size();
  Eigen::MatrixXd C(0, n + 1);
  if constexpr (HoldsConditions<Equations>) C = equations.conditions();
  Eigen::MatrixXd B(n + 1 + C.rows(), n + 1);
  B.topRows(n) = equations.jacobian();
  B.row(n) = row.transpose();
  B.bottomRows(C.rows()) = C;
  return B;
}

/// The x of B x = (right; last; 0) for a matrix of bordered_jacobian: LU with pivoting, or least squares
/// where conditions are held, which solve all rows as these are consistent.
Eigen::VectorXd solve_bordered(const Eigen::MatrixXd& B, const Eigen::VectorXd& right, double last);

/// The point of the curve in the plane tangent . (x - predicted) = 0, by full Newton steps on [R; plane] with
/// the Jacobian [R_x; tangent^T] and the conditions held, if any. Steps are not shortened: where Newton's
/// method fails the caller shortens the step along the curve.
///
/// Converged: |R| <= tolerance max(1, |x|), or no longer falling and either within a hundred times its noise
/// or after a step of less than 1e-10 max(1, |x|).
///
/// \return the point, where `equations` are left evaluated. Empty where it fails.
template <CurveEquations Equations>
std::optional<CorrectedPoint> corrected(Equations& equations, const Eigen::VectorXd& predicted,
                                        const Eigen::VectorXd& tangent, const CorrectorLimits& limits = {}) {
  constexpr double kLost = 1e3, kNoise = 100.0;  // of R; of the noise
  constexpr double kSettled = 1e-10;  // of x: a step from one rounding of stiff modes' forces to the next
  Eigen::VectorXd x = predicted, step = Eigen::VectorXd::Ones(x.size());
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= limits.iterations; ++k) {
    if constexpr (Settles<Equations>) equations.settle(x);
    if (!equations.evaluate(x)) return std::nullopt;
    const double residual = equations.residual().template lpNorm<Eigen::Infinity>();
    if (!(residual < kLost)) return std::nullopt;
    const double size = std::max(1.0, x.lpNorm<Eigen::Infinity>());
    if (residual <= limits.tolerance * size) return CorrectedPoint{std::move(x), k};
    const bool rounding =
        residual < kNoise * equations.noise() || step.lpNorm<Eigen::Infinity>() < kSettled * size;
    if (k >= 2 && rounding && residual > 0.5 * before) return CorrectedPoint{std::move(x), k};
    before = residual;
    step = solve_bordered(bordered_jacobian(equations, tangent), -equations.residual(),
                          -tangent.dot(x - predicted));
    if (!step.allFinite()) return std::nullopt;
    x += step;
  }
  return std::nullopt;
}

/// The Newton steps of `corrected`.
template <CurveEquations Equations>
std::optional<int> correct(Equations& equations, const Eigen::VectorXd& predicted,
                           const Eigen::VectorXd& tangent, const CorrectorLimits& limits = {}) {
  const auto point = corrected(equations, predicted, tangent, limits);
  return point ? std::optional(point->iterations) : std::nullopt;
}

/// The point of the curve nearby where the parameter is what it is in `predicted`.
template <CurveEquations Equations>
std::optional<int> correct_at_parameter(Equations& equations, const Eigen::VectorXd& predicted) {
  return correct(equations, predicted, Eigen::VectorXd::Unit(predicted.size(), predicted.size() - 1),
                 {.iterations = 15});
}

/// The unit null vector of [R_x] where the equations are evaluated, on the side of `previous`; empty where
/// the bordered matrix is singular.
template <CurveEquations Equations>
std::optional<Eigen::VectorXd> tangent_of(Equations& equations, const Eigen::VectorXd& previous) {
  const Eigen::VectorXd t =
      solve_bordered(bordered_jacobian(equations, previous), Eigen::VectorXd::Zero(equations.size()), 1.0);
  if (!t.allFinite() || t.isZero(0.0)) return std::nullopt;
  return t.normalized();
}

/// The same without a predecessor: the right singular vector of the smallest singular value, of either sign.
template <CurveEquations Equations>
Eigen::VectorXd first_tangent(Equations& equations) {
  if (equations.size() == 0) return Eigen::VectorXd::Ones(1);  // the parameter alone
  Eigen::MatrixXd jacobian = equations.jacobian();
  if constexpr (HoldsConditions<Equations>) {
    const Eigen::MatrixXd C = equations.conditions();
    jacobian.conservativeResize(jacobian.rows() + C.rows(), Eigen::NoChange);
    jacobian.bottomRows(C.rows()) = C;
  }
  return right_singular_vectors(jacobian).col(equations.size());
}

/// The same of the sign that leads to larger parameters, or to smaller ones.
template <CurveEquations Equations>
Eigen::VectorXd first_tangent(Equations& equations, bool larger) {
  const Eigen::VectorXd tangent = first_tangent(equations);
  return tangent[equations.size()] * (larger ? 1.0 : -1.0) >= 0.0 ? tangent : -tangent;
}

/// The length of the next step after one that took so many Newton steps and turned by so much.
/// \param turn  angle between the tangents at both ends [rad]
inline double next_step(double length, int iterations, double turn, double largest) {
  constexpr double kTurning = 0.15;  // rad
  double factor = iterations <= 2 ? 1.6 : iterations == 3 ? 1.25 : iterations == 4 ? 1.0 : 0.6;
  if (turn > kTurning) factor = std::min(factor, 0.75);
  return std::min(length * factor, largest);
}

/// Of several values of the parameter the one that a step passes first; empty where it passes none. One at
/// which the step begins, to 1e-12, is not passed.
inline std::optional<double> first_passed(const std::vector<double>& values, double begin, double end) {
  constexpr double kAt = 1e-12;
  std::optional<double> first;
  for (const double value : values) {
    const bool passed = (begin - value) * (end - value) < 0.0 && std::abs(begin - value) > kAt;
    if (passed && (!first || std::abs(begin - value) < std::abs(begin - *first))) first = value;
  }
  return first;
}

/// A point of a curve with its tangent, and the step from there that leads to the next one.
struct CurveStep {
  Eigen::VectorXd x, tangent;
  double length = 0.0;  ///< along the tangent
};

/// The points of a step that are known: x(s) = x(0) + s x'(0) + s^2 q(s), and q is interpolated between the
/// nearest of them. As all are in their planes of the step, so is what is predicted.
class PointsOfStep {
 public:
  explicit PointsOfStep(const CurveStep& step) : step_(step) {}

  /// In place of those next to it: differences of q are divided by what lies between.
  void add(double length, const Eigen::VectorXd& x) {
    constexpr double kApart = 1e-3;  // of the step
    if (!(length > kApart * step_.length)) return;
    std::erase_if(known_,
                  [&](const Known& one) { return std::abs(one.length - length) <= kApart * step_.length; });
    known_.push_back({length, (x - step_.x - length * step_.tangent) / (length * length)});
  }

  /// The point of the curve at a length, by the curve's tangent alone where no other point is known.
  [[nodiscard]] Eigen::VectorXd at(double length) {
    constexpr std::size_t kNearest = 3;
    std::sort(known_.begin(), known_.end(), [length](const Known& one, const Known& other) {
      return std::abs(one.length - length) < std::abs(other.length - length);
    });
    const std::size_t count = std::min(kNearest, known_.size());
    Eigen::VectorXd x = step_.x + length * step_.tangent;
    for (std::size_t i = 0; i < count; ++i) {
      double weight = length * length;  // Lagrange's
      for (std::size_t k = 0; k < count; ++k) {
        if (k != i) weight *= (length - known_[k].length) / (known_[i].length - known_[k].length);
      }
      x += weight * known_[i].q;
    }
    return x;
  }

 private:
  struct Known {
    double length;
    Eigen::VectorXd q;
  };
  const CurveStep& step_;
  std::vector<Known> known_;
};

/// The zero of f between the beginning of a step, where it has the value `first`, and its end, where it is
/// `last` of the other sign: Illinois' rule on the length of the step, each evaluation a corrector of its
/// own, which begins at what the ones before predict. Where f does not exist at the beginning, the step is
/// halved until f exists with the other sign; where it never does, the zero is where it begins to exist.
///
/// \param f  std::optional<double>(Equations&), where the equations are evaluated
/// \return the length; `equations` are left evaluated there. Empty where it cannot be found.
template <CurveEquations Equations, class Function>
std::optional<double> locate(Equations& equations, const CurveStep& step, const Function& f,
                             std::optional<double> first, double last) {
  constexpr CorrectorLimits kTight{.iterations = 14, .tolerance = 1e-14};
  constexpr int kHalvings = 50, kIterations = 200;
  constexpr double kZero = 2e-15;                                           // of f
  constexpr double kNarrow = 4.0 * std::numeric_limits<double>::epsilon();  // of the step
  PointsOfStep points(step);
  const auto value = [&](double length) -> std::optional<double> {
    const auto point = corrected(equations, points.at(length), step.tangent, kTight);
    if (!point) return std::nullopt;
    if (first) points.add(length, point->x);  // none while it is not known whether f exists
    return f(equations);
  };
  double a = 0.0, b = step.length, fb = last;
  for (int k = 0; !first && k < kHalvings; ++k) {
    const double middle = 0.5 * (a + b);
    const auto there = value(middle);
    if (there && *there * last > 0.0) {
      b = middle;
      fb = *there;
    } else {
      a = middle;
      if (there) first = there;
    }
  }
  if (!first) return value(b) ? std::optional(b) : std::nullopt;
  if (!(*first * fb < 0.0)) return std::nullopt;
  double fa = *first, width = std::abs(b - a);
  for (int k = 0; k < kIterations && std::abs(b - a) > kNarrow * step.length; ++k) {
    double s = b - fb * (b - a) / (fb - fa);
    // Bisection where three steps have not halved the interval, as at a jump.
    const bool slow = k % 4 == 3 && std::abs(b - a) > 0.5 * width;
    if (k % 4 == 3) width = std::abs(b - a);
    if (slow || !(s > std::min(a, b) && s < std::max(a, b))) s = 0.5 * (a + b);
    const auto fs = value(s);
    if (!fs) return std::nullopt;
    if (std::abs(*fs) <= kZero || (!slow && std::abs(s - b) <= kNarrow * step.length)) return s;
    // Illinois: an end that stays counts half.
    if (*fs * fb < 0.0) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = s;
    fb = *fs;
  }
  return value(b) ? std::optional(b) : std::nullopt;
}

}  // namespace signorini
