#include "methods/orbit/continuation/arc_length.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

namespace {

Eigen::MatrixXd bordered(ExtendedEquations& equations, const Eigen::VectorXd& row) {
  const Eigen::Index n = equations.size();
  Eigen::MatrixXd B(n + 1, n + 1);
  B.topRows(n) = equations.jacobian();
  B.row(n) = row.transpose();
  return B;
}

}  // namespace

std::optional<int> correct(ExtendedEquations& equations, const Eigen::VectorXd& predicted,
                           const Eigen::VectorXd& tangent, const CorrectorLimits& limits) {
  constexpr double kLost = 1e3, kNoise = 100.0;  // of R; of OrbitEquations::noise, between arcs that cancel
  const Eigen::Index n = equations.size();
  Eigen::VectorXd x = predicted, right(n + 1);
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= limits.iterations; ++k) {
    if (!equations.evaluate(x)) return std::nullopt;
    const double residual = equations.residual().lpNorm<Eigen::Infinity>();
    if (!(residual < kLost)) return std::nullopt;
    if (residual <= limits.tolerance * std::max(1.0, x.lpNorm<Eigen::Infinity>())) return k;
    if (k >= 2 && residual < kNoise * equations.equations().noise() && residual > 0.5 * before) return k;
    before = residual;
    right << -equations.residual(), -tangent.dot(x - predicted);
    const Eigen::VectorXd step = bordered(equations, tangent).partialPivLu().solve(right);
    if (!step.allFinite()) return std::nullopt;
    x += step;
  }
  return std::nullopt;
}

std::optional<int> correct_at_parameter(ExtendedEquations& equations, const Eigen::VectorXd& predicted) {
  return correct(equations, predicted, Eigen::VectorXd::Unit(predicted.size(), predicted.size() - 1),
                 {.iterations = 15});
}

std::optional<Eigen::VectorXd> tangent_of(ExtendedEquations& equations, const Eigen::VectorXd& previous) {
  const Eigen::Index n = equations.size();
  const Eigen::VectorXd t =
      bordered(equations, previous).partialPivLu().solve(Eigen::VectorXd::Unit(n + 1, n));
  if (!t.allFinite() || t.isZero(0.0)) return std::nullopt;
  return t.normalized();
}

Eigen::VectorXd first_tangent(ExtendedEquations& equations) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations.jacobian(), Eigen::ComputeFullV);
  return svd.matrixV().col(equations.size());
}

std::optional<double> locate(ExtendedEquations& equations, const CurveStep& step, const CurveFunction& f,
                             std::optional<double> first, double last) {
  constexpr CorrectorLimits kTight{.iterations = 14, .tolerance = 1e-14};
  constexpr int kHalvings = 50, kIterations = 200;
  constexpr double kZero = 2e-15, kNarrow = 4.0 * kEpsilon;  // of f and of the step
  const auto value = [&](double length) -> std::optional<double> {
    if (!correct(equations, step.x + length * step.tangent, step.tangent, kTight)) return std::nullopt;
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
