#include "methods/periodic_motion/steady_state.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

namespace signorini {

namespace {

// A smaller order whose residual is within this factor of an accepted one cannot be told from noise.
constexpr double kClear = 1e3;

// Distance of two phases on the circle of one forcing period.
double phase_distance(double a, double b, double period) {
  const double d = std::abs(std::remainder(a - b, period));
  return std::min(d, period - d);
}

double nearest_event(const std::vector<ContactEvent>& events, double phase, double period) {
  double nearest = period;
  for (const ContactEvent& event : events)
    nearest = std::min(nearest, phase_distance(event.time, phase, period));
  return nearest;
}

// Marching with its memory of the last states, newest last.
class March {
 public:
  March(PeriodMap& map, FlowState start, const SteadyLimits& limits, const std::function<bool()>& expired)
      : map_(map), limits_(limits), expired_(expired), state_(std::move(start)) {
    remember();
  }

  SteadyState run();

 private:
  static constexpr std::size_t kTurns = 4;  // of the motion that are remembered and must agree

  void remember();
  void step();
  [[nodiscard]] double repeat(int order) const;
  [[nodiscard]] bool nearly_repeats(int order) const;
  [[nodiscard]] bool repeats_by_itself(int order) const;
  [[nodiscard]] bool contracts_to(const FixedPoint& orbit) const;
  [[nodiscard]] std::optional<int> order_when_marched_on(const FixedPoint& orbit);
  std::optional<SteadyState> propose();
  std::optional<SteadyState> settled();
  void leave_events();
  [[nodiscard]] SteadyState accept(FlowState start, int order, double residual, const std::string& how) const;

  PeriodMap& map_;
  SteadyLimits limits_;
  const std::function<bool()>& expired_;
  FlowState state_;
  std::deque<Eigen::VectorXd> past_;                     // scaled states
  std::deque<std::vector<ContactEvent>> recent_events_;  // events of each period
  long marched_ = 0;
  int moves_ = 0;
};

void March::remember() {
  past_.push_back(map_.scaled(state_.state));
  if (past_.size() > (kTurns + 1) * static_cast<std::size_t>(limits_.max_order) + 1) past_.pop_front();
}

void March::step() {
  FlowRecord record;
  map_.apply(state_, 1, record);
  ++marched_;
  remember();
  recent_events_.push_back(std::move(record.events));
  if (recent_events_.size() > static_cast<std::size_t>(limits_.max_order)) recent_events_.pop_front();
}

// Distance between the last state and the one `order` periods before it.
double March::repeat(int order) const {
  const auto back = static_cast<std::size_t>(order);
  if (past_.size() <= back) return std::numeric_limits<double>::infinity();
  return (past_.back() - past_[past_.size() - 1 - back]).lpNorm<Eigen::Infinity>();
}

// The last turns differ little from each other: worth asking Newton's method.
bool March::nearly_repeats(int order) const {
  constexpr double kNear = 0.1;
  const auto p = static_cast<std::size_t>(order);
  if (past_.size() < (kTurns - 1) * p + 2) return false;
  for (std::size_t turn = 0; turn + 1 < kTurns; ++turn) {
    const std::size_t i = past_.size() - 1 - turn * p;
    if (i < p || !((past_[i] - past_[i - p]).lpNorm<Eigen::Infinity>() <= kNear)) return false;
  }
  return true;
}

// Without Newton's help: repetition within the tolerance over several turns, and little still to come.
bool March::repeats_by_itself(int order) const {
  constexpr double kRest = 10.0;
  const auto p = static_cast<std::size_t>(order);
  if (past_.size() < p + kTurns + 1) return false;
  std::vector<double> residuals;
  for (std::size_t i = 0; i < kTurns + p && past_.size() > i + p; ++i) {
    const std::size_t last = past_.size() - 1 - i;
    residuals.push_back((past_[last] - past_[last - p]).lpNorm<Eigen::Infinity>());
  }
  if (*std::max_element(residuals.begin(), residuals.end()) > limits_.accepted()) return false;
  if (residuals.front() == 0.0) return true;
  const double turns = static_cast<double>(residuals.size() - 1) / order;
  const double ratio = std::pow(residuals.front() / residuals.back(), 1.0 / turns);
  return ratio < 1.0 && residuals.front() * ratio / (1.0 - ratio) <= kRest * limits_.accepted();
}

// In the basis of the eigenvectors a linear map with multipliers inside the unit circle shrinks every
// distance; the states marched must do so too, at least by a third of what the slowest multiplier promises.
bool March::contracts_to(const FixedPoint& orbit) const {
  constexpr double kShare = 1.0 / 3.0;
  constexpr double kIllConditioned = 1e8;
  const Eigen::VectorXd fixed = map_.scaled(orbit.start.state);
  Eigen::MatrixXcd to_modes = Eigen::MatrixXcd::Identity(fixed.size(), fixed.size());
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(orbit.monodromy);
  if (modes.info() == Eigen::Success) {
    const Eigen::FullPivLU<Eigen::MatrixXcd> lu(modes.eigenvectors());
    if (lu.rcond() * kIllConditioned > 1.0) to_modes = lu.inverse();
  }
  std::vector<double> distance;
  for (const Eigen::VectorXd& state : past_) {
    const Eigen::VectorXd offset = state - fixed;
    const double length = offset.lpNorm<Eigen::Infinity>();
    // At the noise of the integration nothing shrinks any more.
    distance.push_back(length <= limits_.accepted() ? 0.0 : (to_modes * offset).norm());
  }
  const double factor = 1.0 - kShare * (1.0 - orbit.largest_multiplier());
  const auto p = static_cast<std::size_t>(orbit.order);
  const std::size_t turns = std::min((distance.size() - 1) / p, kTurns);
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const std::size_t i = distance.size() - 1 - turn * p;
    if (distance[i] > factor * distance[i - p]) return false;
  }
  return turns == kTurns;
}

// The smallest order at which the motion from the orbit repeats itself, if any does.
std::optional<int> March::order_when_marched_on(const FixedPoint& orbit) {
  const int turns = std::max(4, 3 * orbit.order);
  FlowState state = orbit.start;
  std::vector<Eigen::VectorXd> states{map_.scaled(state.state)};
  for (int k = 0; k < turns; ++k) {
    FlowRecord record;
    map_.apply(state, 1, record);
    states.push_back(map_.scaled(state.state));
  }
  for (int order = 1; order <= orbit.order; ++order) {
    double worst = 0.0;
    for (std::size_t i = static_cast<std::size_t>(order); i < states.size(); ++i) {
      worst = std::max(worst,
                       (states[i] - states[i - static_cast<std::size_t>(order)]).lpNorm<Eigen::Infinity>());
    }
    if (worst <= limits_.accepted()) return order;
    if (order < orbit.order && worst <= kClear * limits_.accepted()) return std::nullopt;
  }
  return std::nullopt;
}

SteadyState March::accept(FlowState start, int order, double residual, const std::string& how) const {
  return {.periodic = true,
          .message = fmt::format("periodic with order {} after {} periods{}", order, marched_, how),
          .start = std::move(start),
          .order = order,
          .residual = residual,
          .iterations = map_.periods()};
}

// Newton's method from the present state, for the orders at which it nearly repeats.
std::optional<SteadyState> March::propose() {
  constexpr int kTries = 3;
  constexpr int kLargest = 400;  // unknowns for which a monodromy matrix is formed
  if (past_.back().size() > kLargest) return std::nullopt;
  const NewtonLimits newton{
      .accepted = limits_.accepted(), .max_iterations = 8, .max_halvings = 0, .largest_step = 1.0};
  double tried = std::numeric_limits<double>::infinity();
  int tries = 0;
  for (int order = 1; order <= limits_.max_order && tries < kTries; ++order) {
    const double distance = repeat(order);
    if (!nearly_repeats(order) || distance > 0.5 * tried) continue;
    tried = distance;
    ++tries;
    const FixedPoint orbit = find_fixed_point(map_, state_, order, newton, expired_);
    if (!orbit.converged || !(orbit.largest_multiplier() < 1.0) || !contracts_to(orbit)) continue;
    const auto smallest = order_when_marched_on(orbit);
    if (!smallest) continue;
    SteadyState found = accept(orbit.start, *smallest, orbit.residual,
                               fmt::format(", largest multiplier {:.6g}", orbit.largest_multiplier()));
    found.condition = orbit.condition;
    return found;
  }
  return std::nullopt;
}

std::optional<SteadyState> March::settled() {
  for (int order = 1; order <= limits_.max_order; ++order) {
    if (repeats_by_itself(order)) return accept(state_, order, repeat(order), "");
    if (repeat(order) <= kClear * limits_.accepted()) return std::nullopt;
  }
  return std::nullopt;
}

void March::leave_events() {
  constexpr double kNear = 1e-3;  // of a forcing period
  constexpr int kMoves = 5;
  std::vector<ContactEvent> events;
  for (const auto& period : recent_events_) events.insert(events.end(), period.begin(), period.end());
  const double period = map_.forcing_period();
  if (moves_ >= kMoves || nearest_event(events, state_.time, period) > kNear * period) return;
  move_to_quiet_phase(map_, state_, events);
  ++moves_;
  past_.clear();
  remember();
}

SteadyState March::run() {
  constexpr long kShortest = 4, kLongest = 64;  // periods between two proposals
  long pause = kShortest, next = kShortest;
  while (marched_ < limits_.max_iterations) {
    step();
    if (marched_ >= next) {
      const long before = map_.periods();
      if (auto found = propose()) return *found;
      const bool asked = map_.periods() > before;
      pause = asked ? std::min(2 * pause, kLongest) : kShortest;
      next = asked ? marched_ + pause : marched_ + 1;
      if (asked || marched_ % kLongest == 0) leave_events();
    }
    if (auto found = settled()) return *found;
  }
  double best = std::numeric_limits<double>::infinity();
  int order = 1;
  for (int candidate = 1; candidate <= limits_.max_order; ++candidate) {
    if (repeat(candidate) < best) {
      best = repeat(candidate);
      order = candidate;
    }
  }
  return {.periodic = false,
          .message =
              fmt::format("not periodic after {} periods (orders up to {}; nearest order {} within {:.2g})",
                          marched_, limits_.max_order, order, best),
          .start = state_,
          .order = order,
          .residual = best,
          .iterations = map_.periods()};
}

}  // namespace

void move_to_quiet_phase(PeriodMap& map, FlowState& state, const std::vector<ContactEvent>& events) {
  if (events.empty()) return;
  const double period = map.forcing_period();
  constexpr int kCandidates = 64;
  double best = state.time, clearance = -1.0;
  for (int i = 0; i < kCandidates; ++i) {
    const double phase = period * i / kCandidates;
    const double distance = nearest_event(events, phase, period);
    if (distance > clearance) {
      clearance = distance;
      best = phase;
    }
  }
  double wait = std::fmod(best - state.time + period, period);
  if (wait <= 0.0) return;
  FlowRecord record;
  map.flow().advance(state, wait, record);
  state.time = best;
}

SteadyState march(PeriodMap& map, const FlowState& start, const SteadyLimits& limits,
                  const std::function<bool()>& expired) {
  return March(map, start, limits, expired).run();
}

SteadyState shoot(PeriodMap& map, const FlowState& start, int order, const SteadyLimits& limits,
                  const std::function<bool()>& expired) {
  FlowState state = start;
  FlowState probe = start;
  FlowRecord record;
  map.apply(probe, order, record);
  move_to_quiet_phase(map, state, record.events);
  const FixedPoint orbit = find_fixed_point(map, state, order,
                                            {.accepted = limits.accepted(),
                                             .max_iterations = limits.max_iterations,
                                             .max_halvings = 12,
                                             .largest_step = 1e3},
                                            expired);
  return {
      .periodic = orbit.converged,
      .message =
          orbit.converged
              ? fmt::format("periodic with order {} after {} Newton steps, largest multiplier {:.6g}", order,
                            orbit.iterations, orbit.largest_multiplier())
              : fmt::format("no periodic motion after {} Newton steps: {}", orbit.iterations, orbit.reason),
      .start = orbit.start,
      .order = order,
      .residual = orbit.residual,
      .iterations = orbit.iterations,
      .condition = orbit.condition};
}

}  // namespace signorini
