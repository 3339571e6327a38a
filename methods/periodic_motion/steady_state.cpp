#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

namespace {

// A smaller order whose residual is within this factor of an accepted one cannot be told from noise.
constexpr double kClear = 1e3;

constexpr std::size_t kTurns = 4;  // of the motion that are remembered and must agree

// Distance of a phase from the nearest of the events, on the circle of one forcing period.
double nearest_event(const std::vector<ContactEvent>& events, double phase, double period) {
  double nearest = period;
  for (const ContactEvent& event : events)
    nearest = std::min(nearest, std::abs(std::remainder(event.time - phase, period)));
  return nearest;
}

// The smallest order at which the motion from the orbit repeats itself, if any does: the march has shown that
// one of order 1 does.
std::optional<int> order_when_marched_on(PeriodMap& map, const FixedPoint& orbit, double accepted) {
  if (orbit.order == 1) return 1;
  const int turns = 3 * orbit.order;
  FlowState state = orbit.start;
  std::vector<Eigen::VectorXd> states{map.scaled(state.state)};
  for (int k = 0; k < turns; ++k) {
    FlowRecord record;
    map.apply(state, 1, record);
    states.push_back(map.scaled(state.state));
  }
  for (int order = 1; order <= orbit.order; ++order) {
    double worst = 0.0;
    for (auto i = static_cast<std::size_t>(order); i < states.size(); ++i) {
      const Eigen::VectorXd& before = states[i - static_cast<std::size_t>(order)];
      worst = std::max(worst, (states[i] - before).lpNorm<Eigen::Infinity>());
    }
    if (worst <= accepted) return order;
    if (order < orbit.order && worst <= kClear * accepted) return std::nullopt;
  }
  return std::nullopt;
}

std::string success(int order, long marched) {
  return fmt::format("periodic with order {} after {} periods", order, marched);
}

// A state beside an unstable orbit near `state`, along the direction that grows fastest. A march on such an
// orbit, of a symmetric scene from a symmetric start say, does not leave it where rounding keeps the
// symmetry.
std::optional<Eigen::VectorXd> beside_unstable(const FixedPoint& orbit, const Eigen::VectorXd& fixed,
                                               const Eigen::VectorXd& state) {
  constexpr double kNear = 1e-3, kPush = 1e-6;
  if (!(largest_magnitude(orbit.multipliers) > 1.0)) return std::nullopt;
  if (!((state - fixed).lpNorm<Eigen::Infinity>() <= kNear)) return std::nullopt;
  const GeneralEigen modes = general_eigen(orbit.monodromy);
  if (!modes.converged) return std::nullopt;
  Eigen::Index fastest = 0;
  modes.values.cwiseAbs().maxCoeff(&fastest);
  return fixed + kPush * modes.vectors.col(fastest).real().normalized();
}

// An orbit as the states marched near it see it: in the basis of the eigenvectors of its monodromy matrix, in
// which a linear map with multipliers inside the unit circle shrinks every distance.
class Neighbourhood {
 public:
  Neighbourhood(const FixedPoint& orbit, Eigen::VectorXd fixed, double accepted)
      : orbit_(orbit),
        fixed_(std::move(fixed)),
        accepted_(accepted),
        slowest_(largest_magnitude(orbit.multipliers)),
        to_modes_(Eigen::MatrixXcd::Identity(fixed_.size(), fixed_.size())) {
    constexpr double kIllConditioned = 1e8;
    const GeneralEigen modes = general_eigen(orbit.monodromy);
    if (!modes.converged) return;
    const CompleteComplexLuFactors lu(modes.vectors);
    if (lu.reciprocal_condition() * kIllConditioned > 1.0) to_modes_ = lu.inverse();
  }

  // At the noise of the integration nothing shrinks any more.
  [[nodiscard]] double distance(const Eigen::VectorXd& state) const {
    const Eigen::VectorXd offset = state - fixed_;
    return offset.lpNorm<Eigen::Infinity>() <= accepted_ ? 0.0 : (to_modes_ * offset).norm();
  }

  // Each of the last turns brings the motion nearer, at least by a third of what the slowest multiplier
  // promises.
  [[nodiscard]] bool attracts(const std::deque<Eigen::VectorXd>& past) const {
    constexpr double kShare = 1.0 / 3.0;
    const double factor = 1.0 - kShare * (1.0 - slowest_);
    return of_each_turn(past, [&](const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
      return distance(after) <= factor * distance(before);
    });
  }

  // Each of the last turns leads where the monodromy matrix does, but for a tenth of the distance.
  [[nodiscard]] bool is_linear(const std::deque<Eigen::VectorXd>& past) const {
    constexpr double kMisfit = 0.1;
    return of_each_turn(past, [&](const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
      const Eigen::VectorXd misfit = after - fixed_ - orbit_.monodromy * (before - fixed_);
      return distance(after) == 0.0 || (to_modes_ * misfit).norm() <= kMisfit * distance(before);
    });
  }

  // Turns in which the slowest multiplier makes a tenth of a distance, and what it makes of it in them.
  [[nodiscard]] std::pair<int, double> promise() const {
    constexpr double kTenth = 0.1, kMostTurns = 32.0;
    const double turns = std::clamp(std::ceil(std::log(kTenth) / std::log(slowest_)), 1.0, kMostTurns);
    return {static_cast<int>(turns), std::max(kTenth, std::pow(slowest_, turns))};
  }

 private:
  template <typename Holds>
  [[nodiscard]] bool of_each_turn(const std::deque<Eigen::VectorXd>& past, const Holds& holds) const {
    const auto p = static_cast<std::size_t>(orbit_.order);
    if (past.size() <= kTurns * p) return false;
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
      const std::size_t i = past.size() - 1 - turn * p;
      if (!holds(past[i - p], past[i])) return false;
    }
    return true;
  }

  const FixedPoint& orbit_;
  Eigen::VectorXd fixed_;
  double accepted_;
  double slowest_;
  Eigen::MatrixXcd to_modes_;
};

// Marching with its memory of the last states, newest last.
class March {
 public:
  March(PeriodMap& map, FlowState start, const PeriodicMotionOptions& options,
        const std::function<bool()>& expired)
      : map_(map), options_(options), expired_(expired), state_(std::move(start)) {
    remember();
  }

  FixedPoint run();

 private:
  std::optional<FixedPoint> search();
  void remember() {
    past_.push_back(map_.scaled(state_.state));
    if (past_.size() > (kTurns + 1) * static_cast<std::size_t>(options_.max_order) + 1) past_.pop_front();
  }

  void step() {
    FlowRecord record;
    FlowState next = state_;  // the last whole period stays where the time ends in this one
    map_.apply(next, 1, record);
    state_ = std::move(next);
    ++marched_;
    remember();
    recent_events_.push_back(std::move(record.events));
    if (recent_events_.size() > static_cast<std::size_t>(options_.max_order)) recent_events_.pop_front();
  }

  // Distance between the state `ago` periods before the last and the one `order` periods before that;
  // infinite where it is no longer, or not yet, remembered.
  [[nodiscard]] double repeat(int order, std::size_t ago = 0) const {
    const std::size_t back = ago + static_cast<std::size_t>(order);
    if (past_.size() <= back) return kInfinity;
    return (past_[past_.size() - 1 - ago] - past_[past_.size() - 1 - back]).lpNorm<Eigen::Infinity>();
  }

  // The last turns differ little from each other: worth asking Newton's method.
  [[nodiscard]] bool nearly_repeats(int order) const {
    constexpr double kNear = 0.1;
    const auto p = static_cast<std::size_t>(order);
    if (past_.size() < (kTurns - 1) * p + 2) return false;
    for (std::size_t turn = 0; turn + 1 < kTurns; ++turn) {
      if (!(repeat(order, turn * p) <= kNear)) return false;
    }
    return true;
  }

  // Without Newton's help: repetition within the tolerance over several turns, and little still to come: the
  // rest of a geometric sequence whose last term is r and whose ratio is q is r q / (1 - q).
  [[nodiscard]] bool repeats_by_itself(int order) const {
    constexpr double kRest = 10.0;
    const auto p = static_cast<std::size_t>(order);
    if (past_.size() < p + kTurns + 1) return false;
    const std::size_t oldest = std::min(kTurns + p, past_.size() - p) - 1;
    for (std::size_t ago = 0; ago <= oldest; ++ago)
      if (repeat(order, ago) > options_.accepted()) return false;
    const double last = repeat(order);
    if (last == 0.0) return true;
    const double turns = static_cast<double>(oldest) / order;
    const double ratio = std::pow(last / repeat(order, oldest), 1.0 / turns);
    return ratio < 1.0 && last * ratio / (1.0 - ratio) <= kRest * options_.accepted();
  }

  // Newton's method from the present state, for the orders at which it nearly repeats.
  std::optional<FixedPoint> propose() {
    constexpr int kTries = 3;
    constexpr int kLargest = 400;  // unknowns for which a monodromy matrix is formed
    if (past_.back().size() > kLargest) return std::nullopt;
    const NewtonLimits newton{
        .accepted = options_.accepted(), .max_iterations = 8, .max_halvings = 0, .largest_step = 1.0};
    double tried = kInfinity;
    int tries = 0;
    for (int order = 1; order <= options_.max_order && tries < kTries; ++order) {
      const double distance = repeat(order);
      if (!nearly_repeats(order) || distance > 0.5 * tried) continue;
      tried = distance;
      ++tries;
      FixedPoint orbit = find_fixed_point(map_, state_, order, newton, expired_);
      if (orbit.converged && leaves(orbit)) return std::nullopt;
      if (!orbit.converged || !(largest_magnitude(orbit.multipliers) < 1.0) || !comes_to(orbit)) continue;
      const auto smallest = order_when_marched_on(map_, orbit, options_.accepted());
      if (!smallest) continue;
      // The matrix of more periods than the motion's own is a power of its monodromy matrix.
      if (*smallest < order) orbit = find_fixed_point(map_, orbit.start, *smallest, newton, expired_);
      if (!orbit.converged) continue;
      orbit.iterations = map_.periods();
      orbit.message = fmt::format("{}, {}", success(*smallest, marched_), orbit.describe_multipliers());
      return orbit;
    }
    return std::nullopt;
  }

  // An irregular motion may pass a stable orbit, nearer at every turn for a while. It comes to it where these
  // turns are linear, too; else it is marched on, never further away than now, until they are, or the
  // distance has fallen by the root of what the slowest multiplier promises.
  bool comes_to(const FixedPoint& orbit) {
    const Neighbourhood near(orbit, map_.scaled(orbit.start.state), options_.accepted());
    if (!near.attracts(past_)) return false;
    const auto [turns, promised] = near.promise();
    const double start = near.distance(past_.back());
    double now = start;
    const auto surely = [&] { return now == 0.0 || (near.is_linear(past_) && near.attracts(past_)); };
    for (int turn = 0; turn < turns && !surely(); ++turn) {
      if (marched_ + orbit.order > options_.max_iterations) return false;
      for (int k = 0; k < orbit.order; ++k) step();
      now = near.distance(past_.back());
      if (now > start) return false;
    }
    return surely() || now <= std::sqrt(promised) * start;
  }

  // Whether the march stays on an unstable orbit after long: it is then pushed off.
  bool leaves(const FixedPoint& orbit) {
    constexpr long kPatience = 1000;  // periods
    if (marched_ < kPatience) return false;
    const std::optional<Eigen::VectorXd> beside =
        beside_unstable(orbit, map_.scaled(orbit.start.state), past_.back());
    if (!beside) return false;
    state_ = map_.flow().place(state_.time, map_.unscaled(*beside));
    past_.clear();
    remember();
    return true;
  }

  std::optional<FixedPoint> settled() {
    for (int order = 1; order <= options_.max_order; ++order) {
      if (repeats_by_itself(order)) {
        return FixedPoint{.converged = true,
                          .message = success(order, marched_),
                          .start = state_,
                          .order = order,
                          .residual = repeat(order),
                          .iterations = map_.periods()};
      }
      if (repeat(order) <= kClear * options_.accepted()) return std::nullopt;
    }
    return std::nullopt;
  }

  // An event that crosses the section makes the map jump: then Newton's method fails though the motion is
  // smooth everywhere else.
  void leave_events() {
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

  PeriodMap& map_;
  const PeriodicMotionOptions& options_;
  const std::function<bool()>& expired_;
  FlowState state_;
  std::deque<Eigen::VectorXd> past_;                     // scaled states
  std::deque<std::vector<ContactEvent>> recent_events_;  // events of each period
  long marched_ = 0;
  int moves_ = 0;
};

std::optional<FixedPoint> March::search() {
  constexpr long kShortest = 4, kLongest = 64;  // periods between two proposals
  long pause = kShortest, next = kShortest;
  while (marched_ < options_.max_iterations) {
    step();
    if (marched_ >= next) {
      const long before = map_.periods();
      if (auto found = propose()) return found;
      // Newton's method costs several periods: the more often it was asked in vain, the longer it rests.
      const bool asked = map_.periods() > before;
      pause = asked ? std::min(2 * pause, kLongest) : kShortest;
      next = asked ? marched_ + pause : marched_ + 1;
      if (asked || marched_ % kLongest == 0) leave_events();
    }
    if (auto found = settled()) return found;
  }
  return std::nullopt;
}

// Where the time ends, with the state after the last whole period.
FixedPoint March::run() {
  std::string end;
  try {
    if (auto found = search()) return *found;
  } catch (const FlowError& error) {
    if (!expired_()) throw;
    end = error.what();
  }
  int order = 1;
  for (int candidate = 2; candidate <= options_.max_order; ++candidate)
    if (repeat(candidate) < repeat(order)) order = candidate;
  if (end.empty())
    end = fmt::format("not periodic after {} periods (orders up to {}; nearest order {} within {:.2g})",
                      marched_, options_.max_order, order, repeat(order));
  return {.message = end,
          .start = state_,
          .order = order,
          .residual = repeat(order),
          .iterations = map_.periods()};
}

}  // namespace

double PeriodicMotionOptions::accepted() const {
  constexpr double kCvodeNoise = 5e-11, kModalNoise = 1e-12;
  return std::max(10.0 * tolerance, integrator == Integrator::modal ? kModalNoise : kCvodeNoise);
}

void move_to_quiet_phase(PeriodMap& map, FlowState& state, const std::vector<ContactEvent>& events) {
  if (events.empty()) return;
  const double period = map.forcing_period();
  constexpr int kCandidates = 64;
  const auto phase = [&](int i) { return period * i / kCandidates; };
  const auto clearance = [&](int i) { return nearest_event(events, phase(i), period); };
  int widest = 0;
  for (int i = 1; i < kCandidates; ++i)
    if (clearance(i) > clearance(widest)) widest = i;
  const double best = phase(widest);
  const double wait = std::fmod(best - state.time + period, period);
  if (wait <= 0.0) return;
  FlowRecord record;
  map.flow().advance(state, wait, record);
  state.time = best;
}

FixedPoint march(PeriodMap& map, const FlowState& start, const PeriodicMotionOptions& options,
                 const std::function<bool()>& expired) {
  return March(map, start, options, expired).run();
}

FixedPoint shoot(PeriodMap& map, const FlowState& start, int order, const PeriodicMotionOptions& options,
                 const std::function<bool()>& expired) {
  FlowState state = start;
  FlowState probe = start;
  FlowRecord record;
  map.apply(probe, order, record);
  move_to_quiet_phase(map, state, record.events);
  FixedPoint orbit = find_fixed_point(map, state, order,
                                      {.accepted = options.accepted(),
                                       .max_iterations = options.max_iterations,
                                       .max_halvings = 12,
                                       .largest_step = 1e3},
                                      expired);
  orbit.message = orbit.converged ? fmt::format("periodic with order {} after {} Newton steps, {}", order,
                                                orbit.iterations, orbit.describe_multipliers())
                                  : fmt::format("no periodic motion after {} Newton steps: {}",
                                                orbit.iterations, orbit.message);
  return orbit;
}

}  // namespace signorini
