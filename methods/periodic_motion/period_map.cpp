#include "methods/periodic_motion/period_map.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/damped_newton.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

std::string FixedPoint::describe_multipliers() const {
  return order_matters ? "multipliers depend on the order of simultaneous impacts"
                       : fmt::format("largest multiplier {:.6g}", largest_magnitude(multipliers));
}

void PeriodMap::apply(FlowState& state, int count, FlowRecord& record) {
  const double phase = state.time;
  for (int k = 0; k < count; ++k) {
    flow_.advance(state, forcing_period(), record);
    ++periods_;
  }
  state.time = phase;
}

Eigen::VectorXd PeriodMap::scaled(const State& state) const {
  const MotionScales& scales = flow_.dynamics().scales();
  Eigen::VectorXd vector(state.u.size() + state.v.size());
  vector << state.u / scales.displacement, state.v / scales.velocity;
  return vector;
}

State PeriodMap::unscaled(const Eigen::VectorXd& vector) const {
  const MotionScales& scales = flow_.dynamics().scales();
  const ContactDynamics& dynamics = flow_.dynamics();
  return {.u = vector.head(dynamics.positions()) * scales.displacement,
          .v = vector.tail(dynamics.size()) * scales.velocity};
}

namespace {

// P^order(y) - y = 0 as damped_newton sees it. An iterate is a FixedPoint to be, with the defect P^order(y) -
// y and, where there is none, the reason as its message.
class PeriodEquations {
 public:
  PeriodEquations(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                  const std::function<bool()>& expired)
      : map_(map),
        order_(order),
        limits_(limits),
        expired_(expired),
        at_(evaluate(guess)),
        reason_(at_.point.message) {}

  // A residual that is accepted already is reduced once more, for it costs one evaluation.
  void refine() { accepted_ = 0.0; }
  [[nodiscard]] bool solved() const { return at_.point.residual <= accepted_; }
  [[nodiscard]] double merit() const { return at_.point.residual; }
  std::optional<double> find_step() {
    if (!at_.point.message.empty()) return std::nullopt;
    // P(y + s) - (y + s) = 0 to the first order: (I - P') s = P(y) - y.
    const Eigen::Index size = at_.defect.size();
    lu_ = CompleteLuFactors(Eigen::MatrixXd::Identity(size, size) - at_.point.monodromy);
    step_ = lu_.solve(at_.defect);
    // Of a matrix without full rank the estimate knows only the part that can be inverted.
    if (!lu_.regular() || !(lu_.reciprocal_condition() > kSingularCondition)) {
      reason_ = "a multiplier is 1 (singular)";
      return std::nullopt;
    }
    if (!(step_.lpNorm<Eigen::Infinity>() <= limits_.largest_step)) {
      reason_ = "the Newton step leaves the neighbourhood";
      return std::nullopt;
    }
    reason_ = "no reduction along the Newton step (the sequence of events changes)";
    return 1.0;
  }

  std::optional<double> merit_at(double length) {
    const State trial = map_.unscaled(map_.scaled(at_.point.start.state) + length * step_);
    trial_ = evaluate(map_.flow().place(at_.point.start.time, trial));
    if (!trial_.point.message.empty()) {
      reason_ = trial_.point.message;
      return std::nullopt;
    }
    return trial_.point.residual;
  }

  void accept() {
    at_ = std::move(trial_);
    condition_ = condition_from(lu_.reciprocal_condition());
    reason_.clear();
  }

  // The iterate, converged or not.
  [[nodiscard]] FixedPoint result() const {
    FixedPoint point = at_.point;
    point.condition = condition_;
    point.converged = point.residual <= limits_.accepted;
    point.message = point.converged   ? ""
                    : reason_.empty() ? "no convergence within the Newton steps allowed"
                                      : reason_;
    if (point.converged) point.multipliers = general_eigenvalues(point.monodromy);
    return point;
  }

 private:
  struct Iterate {
    FixedPoint point = {};
    Eigen::VectorXd defect = {};
  };

  [[nodiscard]] Iterate evaluate(const FlowState& start) {
    Iterate at{
        .point = {.start = start, .order = order_, .residual = std::numeric_limits<double>::infinity()}};
    const MotionScales& scales = map_.flow().dynamics().scales();
    const Eigen::Index p = start.state.u.size(), n = start.state.v.size();
    FlowState end = start;
    FlowRecord record;
    record.tangent = true;
    try {
      map_.apply(end, order_, record);
    } catch (const std::runtime_error& error) {
      if (expired_()) throw;
      at.point.message = error.what();
      return at;
    }
    at.point.order_matters = record.order_matters;
    at.defect = map_.scaled(end.state) - map_.scaled(start.state);
    // The derivative of the flow is that of (u, xi, v); here it is wanted of (u / X, xi / X, v / V).
    Eigen::MatrixXd& derivative = at.point.monodromy = std::move(record.derivative);
    const double ratio = scales.velocity / scales.displacement;
    derivative.topRightCorner(p, n) *= ratio;
    derivative.bottomLeftCorner(n, p) /= ratio;
    const double residual = at.defect.lpNorm<Eigen::Infinity>();
    if (std::isfinite(residual) && derivative.allFinite()) {
      at.point.residual = residual;
    } else {
      // The saltation matrix divides by the approach speed, which is zero where a contact grazes.
      at.point.message = "the period map or its derivative is not finite (grazing contact)";
    }
    return at;
  }

  PeriodMap& map_;
  int order_;
  const NewtonLimits& limits_;
  const std::function<bool()>& expired_;
  double accepted_ = limits_.accepted;
  Iterate at_, trial_;
  CompleteLuFactors lu_;
  Eigen::VectorXd step_;
  std::optional<double> condition_;
  std::string reason_;  // of the last failure
};

}  // namespace

FixedPoint find_fixed_point(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                            const std::function<bool()>& expired) {
  constexpr double kSufficient = 0.25;  // a map that changes its sequence of events is far from linear
  PeriodEquations equations(map, guess, order, limits, expired);
  const DampedNewtonResult search = damped_newton(equations, {.max_steps = limits.max_iterations,
                                                              .max_halvings = limits.max_halvings,
                                                              .sufficient_decrease = kSufficient});
  int steps = search.steps;
  if (search.end == NewtonEnd::solved && search.steps < limits.max_iterations) {
    equations.refine();
    steps += damped_newton(equations, {.max_steps = 1, .max_halvings = 0, .sufficient_decrease = kSufficient})
                 .steps;
  }
  FixedPoint point = equations.result();
  point.iterations = steps;
  return point;
}

}  // namespace signorini
