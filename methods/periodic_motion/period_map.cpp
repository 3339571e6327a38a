#include "methods/periodic_motion/period_map.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/damped_newton.hpp"

namespace signorini {

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
  Eigen::VectorXd vector(2 * state.u.size());
  vector << state.u / scales.displacement, state.v / scales.velocity;
  return vector;
}

State PeriodMap::unscaled(const Eigen::VectorXd& vector) const {
  const MotionScales& scales = flow_.dynamics().scales();
  const Eigen::Index n = vector.size() / 2;
  return {.u = vector.head(n) * scales.displacement, .v = vector.tail(n) * scales.velocity};
}

double PeriodMap::distance(const State& a, const State& b) const {
  return (scaled(a) - scaled(b)).lpNorm<Eigen::Infinity>();
}

double FixedPoint::largest_multiplier() const {
  return multipliers.size() == 0 ? 0.0 : multipliers.cwiseAbs().maxCoeff();
}

namespace {

// The map at one state, and its derivative there, in scaled coordinates.
struct MapValue {
  FlowState start;
  Eigen::VectorXd defect;  // P^order(y) - y
  Eigen::MatrixXd derivative;
  double residual = std::numeric_limits<double>::infinity();
  std::string failure;  // why there is no defect
};

// P^order(y) - y = 0 as damped_newton sees it.
class PeriodEquations {
 public:
  PeriodEquations(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                  const std::function<bool()>& expired)
      : map_(map),
        order_(order),
        limits_(limits),
        expired_(expired),
        at_(evaluate(guess)),
        reason_(at_.failure) {}

  // A residual that is accepted already is reduced once more, for it costs one evaluation.
  void refine() { accepted_ = 0.0; }
  [[nodiscard]] bool solved() const { return at_.residual <= accepted_; }
  [[nodiscard]] double merit() const { return at_.residual; }
  std::optional<double> find_step();
  std::optional<double> merit_at(double length);
  void accept() {
    at_ = std::move(trial_);
    condition_ = condition_from(lu_.rcond());
    reason_.clear();
  }

  [[nodiscard]] MapValue& value() { return at_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] std::optional<double> condition() const { return condition_; }

 private:
  [[nodiscard]] MapValue evaluate(const FlowState& start);

  PeriodMap& map_;
  int order_;
  const NewtonLimits& limits_;
  const std::function<bool()>& expired_;
  double accepted_ = limits_.accepted;
  MapValue at_, trial_;
  Eigen::FullPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd step_;
  std::optional<double> condition_;
  std::string reason_;  // of the last failure
};

MapValue PeriodEquations::evaluate(const FlowState& start) {
  MapValue value{.start = start, .defect = {}, .derivative = {}, .failure = {}};
  const MotionScales& scales = map_.flow().dynamics().scales();
  const Eigen::Index n = start.state.u.size();
  FlowState end = start;
  FlowRecord record;
  record.tangent = true;
  try {
    map_.apply(end, order_, record);
  } catch (const std::runtime_error& error) {
    if (expired_()) throw;
    value.failure = error.what();
    return value;
  }
  value.defect = map_.scaled(end.state) - map_.scaled(start.state);
  value.derivative = std::move(record.derivative);
  const double ratio = scales.velocity / scales.displacement;
  value.derivative.topRightCorner(n, n) *= ratio;
  value.derivative.bottomLeftCorner(n, n) /= ratio;
  value.residual = value.defect.lpNorm<Eigen::Infinity>();
  if (!std::isfinite(value.residual) || !value.derivative.allFinite()) {
    // The saltation matrix divides by the approach speed, which is zero where a contact grazes.
    value.residual = std::numeric_limits<double>::infinity();
    value.failure = "the period map or its derivative is not finite (grazing contact)";
  }
  return value;
}

std::optional<double> PeriodEquations::find_step() {
  constexpr double kSingular = 1e-13;  // reciprocal condition of I - derivative
  if (!at_.failure.empty()) return std::nullopt;
  const Eigen::Index size = at_.defect.size();
  lu_.compute(Eigen::MatrixXd::Identity(size, size) - at_.derivative);
  step_ = lu_.solve(at_.defect);
  // Of a matrix without full rank the estimate knows only the part that can be inverted.
  if (!lu_.isInvertible() || !(lu_.rcond() > kSingular)) {
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

std::optional<double> PeriodEquations::merit_at(double length) {
  const State trial = map_.unscaled(map_.scaled(at_.start.state) + length * step_);
  trial_ = evaluate(map_.flow().place(at_.start.time, trial));
  if (!trial_.failure.empty()) {
    reason_ = trial_.failure;
    return std::nullopt;
  }
  return trial_.residual;
}

}  // namespace

FixedPoint find_fixed_point(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                            const std::function<bool()>& expired) {
  constexpr double kSufficient = 0.25;  // a map that changes its sequence of events is far from linear
  PeriodEquations equations(map, guess, order, limits, expired);
  FixedPoint point;
  point.order = order;
  const DampedNewtonResult search = damped_newton(equations, {.max_steps = limits.max_iterations,
                                                              .max_halvings = limits.max_halvings,
                                                              .sufficient_decrease = kSufficient});
  point.iterations = search.steps;
  if (search.end == NewtonEnd::solved && search.steps < limits.max_iterations) {
    equations.refine();
    point.iterations +=
        damped_newton(equations, {.max_steps = 1, .max_halvings = 0, .sufficient_decrease = kSufficient})
            .steps;
  }
  MapValue& last = equations.value();
  point.condition = equations.condition();
  point.start = last.start;
  point.residual = last.residual;
  point.converged = last.residual <= limits.accepted;
  point.monodromy = std::move(last.derivative);
  if (point.converged) {
    point.multipliers = point.monodromy.eigenvalues();
  } else {
    point.reason =
        equations.reason().empty() ? "no convergence within the Newton steps allowed" : equations.reason();
  }
  return point;
}

}  // namespace signorini
