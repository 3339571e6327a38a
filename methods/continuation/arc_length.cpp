#include "methods/continuation/arc_length.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

// The points of a step that are known: x(s) = x(0) + s x'(0) + s^2 q(s), and q is interpolated between the
// nearest of them. As all are in their planes of the step, so is what is predicted.
class PointsOfStep {
 public:
  explicit PointsOfStep(const CurveStep& step) : step_(step) {}

  // In place of those next to it: differences of q are divided by what lies between.
  void add(double length, const Eigen::VectorXd& x) {
    constexpr double kApart = 1e-3;  // of the step
    if (!(length > kApart * step_.length)) return;
    std::erase_if(known_,
                  [&](const Known& one) { return std::abs(one.length - length) <= kApart * step_.length; });
    known_.push_back({length, (x - step_.x - length * step_.tangent) / (length * length)});
  }

  // The point of the curve at a length, by the curve's tangent alone where no other point is known.
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

}  // namespace

Eigen::MatrixXd bordered_jacobian(const AnyEquations& equations, const Eigen::VectorXd& row) {
  const Eigen::Index n = equations.size();
  const Eigen::MatrixXd C = equations.conditions();
  Eigen::MatrixXd B(n + 1 + C.rows(), n + 1);
  B.topRows(n) = equations.jacobian();
  B.row(n) = row.transpose();
  B.bottomRows(C.rows()) = C;
  return B;
}

Eigen::VectorXd solve_bordered(const Eigen::MatrixXd& B, const Eigen::VectorXd& right, double last) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(B.rows());
  all.head(right.size()) = right;
  all[right.size()] = last;
  return B.rows() == B.cols() ? lu_solve(B, all) : full_rank_least_squares(B, all);
}

namespace {

// What a corrector has come to.
struct Progress {
  double residual, before;  // |R| here and at the step before
  double step;              // the last one
  int steps;
};

// Whether R is as small as wanted, or rounding that falls no further.
bool solved(const AnyEquations& equations, double tolerance, double size, const Progress& at) {
  constexpr double kSettled = 1e-10;  // of x: a step from one rounding of stiff modes' forces to the next
  if (at.residual <= tolerance * size) return true;
  const bool rounding = at.residual < kNoiseMargin * equations.noise() || at.step < kSettled * size;
  return at.steps >= 2 && rounding && at.residual > 0.5 * at.before;
}

double size_of(const Eigen::VectorXd& x) { return std::max(1.0, x.lpNorm<Eigen::Infinity>()); }

// The next of the steps with the matrix of `near`, which each step since has corrected by the change of R
// that it made, without forming it [broyden1965].
Eigen::VectorXd secant_step(const CurveFactors& near, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& tangent, const std::vector<Eigen::VectorXd>& steps) {
  Eigen::VectorXd step = near.solve(-residual, tangent);
  for (std::size_t j = 0; j + 1 < steps.size(); ++j)
    step += steps[j].dot(step) / steps[j].squaredNorm() * steps[j + 1];
  if (!steps.empty()) step /= 1.0 - steps.back().dot(step) / steps.back().squaredNorm();
  return step;
}

// A point of the curve, and the Newton steps that led to it.
struct CorrectedPoint {
  Eigen::VectorXd x;
  int iterations = 0;
};

// From where the residual is evaluated. Empty where it does not fall fast, and of equations whose unknowns
// are put in their places on the way.
std::optional<CorrectedPoint> corrected_by_secants(const AnyEquations& equations,
                                                   const Eigen::VectorXd& predicted,
                                                   const Eigen::VectorXd& tangent, const CurveFactors& near,
                                                   double tolerance) {
  constexpr int kSteps = 12, kLikeOneOfNewton = 3;
  constexpr double kFast = 0.5;  // of the residual before: slower ones cost more than a Jacobian
  Eigen::VectorXd x = predicted;
  equations.settle(x);
  if (x != predicted) return std::nullopt;
  std::vector<Eigen::VectorXd> steps;
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kSteps; ++k) {
    if (k > 0 && !equations.evaluate_residual(x)) return std::nullopt;
    const double residual = equations.residual().lpNorm<Eigen::Infinity>();
    const double last = steps.empty() ? 1.0 : steps.back().lpNorm<Eigen::Infinity>();
    if (solved(equations, tolerance, size_of(x),
               {.residual = residual, .before = before, .step = last, .steps = k})) {
      if (!equations.evaluate(x)) return std::nullopt;
      return CorrectedPoint{std::move(x), (k + kLikeOneOfNewton - 1) / kLikeOneOfNewton};
    }
    if (!(residual < kFast * before)) return std::nullopt;
    before = residual;
    Eigen::VectorXd step = secant_step(near, equations.residual(), tangent, steps);
    if (!step.allFinite()) return std::nullopt;
    x += step;
    steps.push_back(std::move(step));
  }
  return std::nullopt;
}

std::optional<CorrectedPoint> corrected(const AnyEquations& equations, const Eigen::VectorXd& predicted,
                                        const Eigen::VectorXd& tangent, const CorrectorLimits& limits) {
  constexpr double kLost = 1e3;  // of R
  const auto by_secants = [&](const CurveFactors& near) {
    return corrected_by_secants(equations, predicted, tangent, near, limits.tolerance);
  };
  if (limits.near != nullptr && equations.evaluate_residual(predicted)) {
    if (auto point = by_secants(*limits.near)) return point;
    // Fast modes may turn by radians to a point near, and hardly on the way from what is predicted.
    if (equations.evaluate(predicted)) {
      auto point = by_secants(CurveFactors(equations, tangent));
      if (point) ++point->iterations;
      if (point) return point;
    }
  }
  Eigen::VectorXd x = predicted, step = Eigen::VectorXd::Ones(x.size());
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= limits.iterations; ++k) {
    equations.settle(x);
    if (!equations.evaluate(x)) return std::nullopt;
    const double residual = equations.residual().lpNorm<Eigen::Infinity>();
    if (!(residual < kLost)) return std::nullopt;
    if (solved(equations, limits.tolerance, size_of(x),
               {.residual = residual, .before = before, .step = step.lpNorm<Eigen::Infinity>(), .steps = k}))
      return CorrectedPoint{std::move(x), k};
    before = residual;
    step = solve_bordered(bordered_jacobian(equations, tangent), -equations.residual(),
                          -tangent.dot(x - predicted));
    if (!step.allFinite()) return std::nullopt;
    x += step;
  }
  return std::nullopt;
}

}  // namespace

CurveFactors::CurveFactors(const AnyEquations& equations, const Eigen::VectorXd& row) {
  const Eigen::MatrixXd B = bordered_jacobian(equations, row);
  factors_ = std::make_shared<const LuFactors>(B);
  along_ = factors_->solve(Eigen::VectorXd(Eigen::VectorXd::Unit(row.size(), row.size() - 1)));
  norms_ = B.topRows(row.size() - 1).rowwise().norm().array().log().sum();
}

std::optional<Eigen::VectorXd> CurveFactors::tangent() const {
  if (!along_.allFinite() || along_.isZero(0.0)) return std::nullopt;
  return along_.normalized();
}

Eigen::VectorXd CurveFactors::solve(const Eigen::VectorXd& right, const Eigen::VectorXd& normal) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(right.size() + 1);
  all.head(right.size()) = right;
  const Eigen::VectorXd x = factors_->solve(all);
  return x - normal.dot(x) / normal.dot(along_) * along_;
}

// With [R_x] along = 0 the row of the tangent makes |along| times what `row` does.
double CurveFactors::relative_determinant() const {
  const Eigen::ArrayXd pivots = factors_->pivots().array();
  const double magnitude = std::exp(pivots.abs().log().sum() + std::log(along_.norm()) - norms_);
  return factors_->permutation_sign() * pivots.sign().prod() * magnitude;
}

std::optional<int> correct(const AnyEquations& equations, const Eigen::VectorXd& predicted,
                           const Eigen::VectorXd& tangent, const CorrectorLimits& limits) {
  const auto point = corrected(equations, predicted, tangent, limits);
  return point ? std::optional(point->iterations) : std::nullopt;
}

std::optional<int> correct_at_parameter(const AnyEquations& equations, const Eigen::VectorXd& predicted) {
  return correct(equations, predicted, Eigen::VectorXd::Unit(predicted.size(), predicted.size() - 1),
                 {.iterations = 15});
}

std::optional<Eigen::VectorXd> tangent_of(const AnyEquations& equations, const Eigen::VectorXd& previous) {
  const Eigen::VectorXd t =
      solve_bordered(bordered_jacobian(equations, previous), Eigen::VectorXd::Zero(equations.size()), 1.0);
  if (!t.allFinite() || t.isZero(0.0)) return std::nullopt;
  return t.normalized();
}

Eigen::VectorXd first_tangent(const AnyEquations& equations) {
  if (equations.size() == 0) return Eigen::VectorXd::Ones(1);  // the parameter alone
  Eigen::MatrixXd jacobian = equations.jacobian();
  const Eigen::MatrixXd C = equations.conditions();
  jacobian.conservativeResize(jacobian.rows() + C.rows(), Eigen::NoChange);
  jacobian.bottomRows(C.rows()) = C;
  return right_singular_vectors(jacobian).col(equations.size());
}

Eigen::VectorXd first_tangent(const AnyEquations& equations, bool larger) {
  const Eigen::Index parameter = equations.size();
  const Eigen::VectorXd tangent = first_tangent(equations);
  return tangent[parameter] * (larger ? 1.0 : -1.0) >= 0.0 ? tangent : -tangent;
}

double next_step(double length, int iterations, double turn, double largest) {
  constexpr double kTurning = 0.15;  // rad
  double factor = iterations <= 2 ? 1.6 : iterations == 3 ? 1.25 : iterations == 4 ? 1.0 : 0.6;
  if (turn > kTurning) factor = std::min(factor, 0.75);
  return std::min(length * factor, largest);
}

double longest_step(double usual, double size) {
  constexpr double kFew = 10.0, kShare = 0.4;  // units; of what is beyond
  return usual * (1.0 + kShare * std::max(0.0, size - kFew));
}

namespace {

constexpr double kAtValue = 1e-12;  // of the interval

}  // namespace

std::optional<StepTarget> first_target(const std::vector<double>& values, double low, double high,
                                       double begin, double end) {
  std::optional<StepTarget> first;
  if (end < low || end > high) first = {.value = std::clamp(end, low, high), .leaves = true};
  for (const double value : values) {
    const bool passed =
        (begin - value) * (end - value) < 0.0 && std::abs(begin - value) > kAtValue * (high - low);
    if (passed && (!first || std::abs(begin - value) < std::abs(begin - first->value)))
      first = {.value = value};
  }
  return first;
}

bool turns_past(const std::vector<double>& values, double low, double high, const ParameterAt& begin,
                const ParameterAt& end) {
  if (!(begin.rate * end.rate < 0.0)) return false;
  // p' = begin.rate + 2 a s + 3 b s^2 on 0 <= s <= 1, which changes its sign there once.
  const double rise = end.value - begin.value;
  const double a = 3.0 * rise - 2.0 * begin.rate - end.rate, b = begin.rate + end.rate - 2.0 * rise;
  const double q = -(a + std::copysign(std::sqrt(a * a - 3.0 * b * begin.rate), a));
  const double near = begin.rate / q, far = q / (3.0 * b);
  const double s = near > 0.0 && near < 1.0 ? near : std::clamp(far, 0.0, 1.0);
  const double extreme = begin.value + s * (begin.rate + s * (a + s * b));
  return std::ranges::any_of(values, [&](double value) {
    if (!(value >= low && value <= high)) return false;
    const double before = begin.value - value, beyond = extreme - value, after = end.value - value;
    if (std::abs(before) <= kAtValue * (high - low)) return after * begin.rate < 0.0;
    return before * beyond < 0.0 && after * beyond < 0.0;
  });
}

std::optional<double> locate(const AnyEquations& equations, const CurveStep& step,
                             const std::function<std::optional<double>(const Eigen::VectorXd& x)>& f,
                             std::optional<double> first, double last) {
  constexpr int kHalvings = 50, kIterations = 200;
  constexpr double kZero = 2e-15;                                           // of f
  constexpr double kNarrow = 4.0 * std::numeric_limits<double>::epsilon();  // of the step
  std::optional<CurveFactors> near;                                         // of the first point
  PointsOfStep points(step);
  const auto value = [&](double length) -> std::optional<double> {
    CorrectorLimits limits = kTight;
    limits.near = near ? &*near : nullptr;
    const auto point = corrected(equations, points.at(length), step.tangent, limits);
    if (!point) return std::nullopt;
    if (!near && step.by_secants) near.emplace(equations, step.tangent);
    if (first) points.add(length, point->x);  // none while it is not known whether f exists
    return f(point->x);
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

std::optional<double> length_to_parameter(const AnyEquations& equations, const CurveStep& step,
                                          const Eigen::VectorXd& end, double value) {
  const Eigen::Index last = step.x.size() - 1;
  return locate(
      equations, step, [&](const Eigen::VectorXd& x) { return std::optional(x[last] - value); },
      step.x[last] - value, end[last] - value);
}

}  // namespace signorini
