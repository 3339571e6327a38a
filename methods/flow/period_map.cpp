#include "methods/flow/period_map.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "methods/solvers/condition_estimate.hpp"

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

double Orbit::largest_multiplier() const {
  return multipliers.size() == 0 ? 0.0 : multipliers.cwiseAbs().maxCoeff();
}

namespace {

// One evaluation of the map and its derivative, in scaled coordinates.
struct Shot {
  FlowState start;
  Eigen::VectorXd defect;
  Eigen::MatrixXd derivative;
  double residual = std::numeric_limits<double>::infinity();
  std::string failure;
};

Shot shoot_once(PeriodMap& map, const FlowState& start, int order, const std::function<bool()>& expired) {
  Shot shot{.start = start, .defect = {}, .derivative = {}, .failure = {}};
  const MotionScales& scales = map.flow().dynamics().scales();
  const Eigen::Index n = start.state.u.size();
  FlowState end = start;
  FlowRecord record;
  record.tangent = true;
  try {
    map.apply(end, order, record);
  } catch (const std::runtime_error& error) {
    if (expired()) throw;
    shot.failure = error.what();
    return shot;
  }
  shot.defect = map.scaled(end.state) - map.scaled(start.state);
  shot.derivative = std::move(record.derivative);
  const double ratio = scales.velocity / scales.displacement;
  shot.derivative.topRightCorner(n, n) *= ratio;
  shot.derivative.bottomLeftCorner(n, n) /= ratio;
  shot.residual = shot.defect.lpNorm<Eigen::Infinity>();
  if (!std::isfinite(shot.residual) || !shot.derivative.allFinite()) {
    shot.residual = std::numeric_limits<double>::infinity();
    shot.failure = "the period map or its derivative is not finite (grazing contact)";
  }
  return shot;
}

// The step, halved until the residual falls; empty failure if it does.
Shot damped_step(PeriodMap& map, const Shot& from, const Eigen::VectorXd& step, int order, int max_halvings,
                 const std::function<bool()>& expired) {
  double factor = 1.0;
  Shot best = from;
  for (int halving = 0; halving <= max_halvings; ++halving, factor *= 0.5) {
    const State trial = map.unscaled(map.scaled(from.start.state) + factor * step);
    Shot next = shoot_once(map, map.flow().place(from.start.time, trial), order, expired);
    if (next.residual < (1.0 - 0.25 * factor) * from.residual) return next;
    best.failure = next.failure;
  }
  if (best.failure.empty())
    best.failure = "no reduction along the Newton step (the sequence of events changes)";
  return best;
}

}  // namespace

Orbit newton_orbit(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                   const std::function<bool()>& expired) {
  constexpr double kSingular = 1e-13;  // reciprocal condition of I - derivative
  Orbit orbit;
  orbit.order = order;
  Shot shot = shoot_once(map, guess, order, expired);
  orbit.reason = shot.failure;
  while (shot.failure.empty() && shot.residual > 0.0 && orbit.iterations < limits.max_iterations) {
    const bool polishing = shot.residual <= limits.accepted;
    const Eigen::Index size = shot.defect.size();
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd::Identity(size, size) - shot.derivative);
    const Eigen::VectorXd step = lu.solve(shot.defect);
    const double length = step.lpNorm<Eigen::Infinity>();
    if (!(lu.rcond() > kSingular) || !(length <= limits.largest_step)) {
      orbit.reason = lu.rcond() > kSingular ? "the Newton step leaves the neighbourhood"
                                            : "a multiplier is 1 (singular)";
      break;
    }
    Shot next = damped_step(map, shot, step, order, polishing ? 0 : limits.max_halvings, expired);
    ++orbit.iterations;
    if (!next.failure.empty()) {
      orbit.reason = next.failure;
      break;
    }
    shot = std::move(next);
    orbit.condition = condition_from(lu.rcond());
    if (polishing) break;
  }
  orbit.start = shot.start;
  orbit.residual = shot.residual;
  orbit.converged = shot.residual <= limits.accepted;
  orbit.monodromy = std::move(shot.derivative);
  if (orbit.converged) {
    orbit.multipliers = orbit.monodromy.eigenvalues();
    orbit.reason.clear();
  } else if (orbit.reason.empty()) {
    orbit.reason = "no convergence within the Newton steps allowed";
  }
  return orbit;
}

}  // namespace signorini
