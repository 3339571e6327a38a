#include "harness/motion/long_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "harness/interrupt.hpp"
#include "harness/motion/lyapunov.hpp"
#include "methods/flow/event_trajectory.hpp"
#include "methods/periodic_motion/period_map.hpp"
#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

namespace {

constexpr double kTolerance = 1e-10;     // of the flow's events [-]
constexpr double kStill = 1e-9;          // of the scales: no motion [-]
constexpr std::size_t kLeastSteps = 30;  // of exponents that decide: ten that turn, a value for each batch
constexpr int kHigher = 2;               // times the orders told at first: of a motion that settles late [-]
constexpr double kLarge = 10.0;  // of the scale of the motion: what grows beyond it may be unbounded [-]

/// Whether sizes at the ends of parts, each twice as long as the one before, have grown to the last, which is
/// larger than `large`.
bool keeps_growing(std::span<const double> sizes, double large) {
  constexpr std::size_t kParts = 4;
  constexpr double kGrowth = 1.5;
  if (sizes.size() < kParts || !(sizes.back() > large)) return false;
  const std::span<const double> last = sizes.last(kParts);
  return std::ranges::adjacent_find(
             last, [](double before, double after) { return !(after > kGrowth * before); }) == last.end();
}

/// Forcing periods in which the slowest mode without contact fades to its e-th part; 0 where one does not
/// fade.
double periods_to_fade(const ContactDynamics& dynamics) {
  constexpr double kUndamped = 1e-13;  // of the fastest rate
  const std::vector<bool> open(static_cast<std::size_t>(dynamics.contact_count()), false);
  const Eigen::VectorXcd rates = general_eigenvalues(dynamics.flow_matrix(dynamics.mode(open)));
  const double slowest = -rates.real().maxCoeff();
  if (!(slowest > kUndamped * rates.cwiseAbs().maxCoeff())) return 0.0;
  return 1.0 / (slowest * dynamics.structure().forcing_period);
}

/// log |multiplier| / period, largest first; minus infinity where a multiplier is below the rounding of the
/// matrix. \param monodromy  over the period
std::vector<double> exponents_of(const Eigen::MatrixXd& monodromy, double period) {
  constexpr double kRounding = 1e-14;  // of its norm
  const double least = kRounding * monodromy.norm();
  std::vector<double> all;
  for (const std::complex<double>& multiplier : general_eigenvalues(monodromy))
    all.push_back(std::abs(multiplier) > least ? std::log(std::abs(multiplier)) / period : -kInfinity);
  std::ranges::sort(all, std::greater<>());
  return all;
}

/// The largest exponents of two turns of one period; what they differ by is the error of either.
std::vector<Estimate> exponents_of(const FlowRecord (&turns)[2], double period, std::size_t most) {
  const std::vector<double> one = exponents_of(turns[0].derivative, period),
                            other = exponents_of(turns[1].derivative, period);
  std::vector<Estimate> all;
  for (std::size_t i = 0; i < std::min(one.size(), most); ++i) {
    const double difference = std::abs(one[i] - other[i]);
    all.push_back({.value = one[i], .error = std::isfinite(difference) ? difference : 0.0});
  }
  return all;
}

/// The displacement and the velocity of each contact at an instant.
std::vector<double> section_of(const ContactDynamics& dynamics, const FlowState& at) {
  const MotionDerivatives motion = dynamics.derivatives(dynamics.mode(at.closed), at.time, at.state, 3);
  std::vector<double> row;
  for (const auto& x : motion.x.rowwise()) row.insert(row.end(), {x[0], x[1]});
  return row;
}

/// The least order at which the last rows of a section repeat, if there is one: over four times the order,
/// and 64 rows at least, as displacements, which impacts do not jump over.
std::optional<int> repeating_order(const std::vector<std::vector<double>>& section, int max_order) {
  constexpr double kNear = 1e-3;  // of the range of x over all rows: nearer than tori mostly come
  constexpr int kTurns = 4, kLeastRows = 64;
  if (section.empty()) return std::nullopt;
  std::vector<double> near(section.front().size());
  for (std::size_t j = 0; j < near.size(); j += 2) {
    const auto [least, largest] =
        std::ranges::minmax_element(section, {}, [j](const auto& row) { return row[j]; });
    near[j] = kNear * ((*largest)[j] - (*least)[j]);
  }
  const auto equal = [&near](const std::vector<double>& one, const std::vector<double>& other) {
    for (std::size_t j = 0; j < near.size(); j += 2)
      if (std::abs(one[j] - other[j]) > near[j]) return false;
    return true;
  };
  for (int order = 1; order <= max_order; ++order) {
    const int rows = std::max(kLeastRows, kTurns * order);
    if (std::cmp_less(section.size(), rows + order)) return std::nullopt;
    if (std::equal(section.end() - rows, section.end(), section.end() - rows - order, equal)) return order;
  }
  return std::nullopt;
}

/// Whether small deviations fade: an exponent that is negative beyond its error, and beyond rounding where
/// all steps are alike.
bool fades(const Estimate& per_period) {
  constexpr double kRounding = 1e-9;
  return per_period.value < -per_period.error - kRounding;
}

/// Whether they have faded to their e-th part since the start: else they do not in as many periods more.
bool has_faded(const LyapunovSum& deviations, long marched) {
  if (deviations.steps() < kLeastSteps) return false;
  const Estimate largest = deviations.exponents().front();
  return fades(largest) && largest.value * static_cast<double>(marched) < -1.0;
}

/// The exponents of a motion that does not settle, and the verdict by the largest one.
void decide(const LyapunovSum& deviations, const PeriodMap& map, const LongMotionOptions& options,
            LongMotion& result) {
  constexpr double kTorusError = 5e-3;  // per period
  constexpr double kTorusGrowth = 6.0;  // logarithm: tenfold by an even drift, the rest along the curve
  constexpr double kFaded = 3.0;        // times that in which a mode fades: it has settled
  constexpr double kGrown = 20.0;       // logarithm of the growth of a deviation over the whole time
  const std::string_view further =
      result.measured < options.periods ? "more time decides" : "more periods decide";
  if (deviations.steps() < kLeastSteps) {
    result.reason =
        fmt::format("not periodic, and only {} periods could be measured: {}", result.measured, further);
    return;
  }
  result.lyapunov = deviations.exponents();
  const Estimate largest = result.lyapunov.front();
  for (Estimate& exponent : result.lyapunov) {
    exponent.value /= map.forcing_period();
    exponent.error /= map.forcing_period();
  }
  const double grown = deviations.largest_growth();
  if (largest.value > largest.error && largest.value * static_cast<double>(deviations.steps()) > kGrown) {
    result.verdict = LongRun::irregular;
  } else if (const double fading = periods_to_fade(map.flow().dynamics());
             kFaded * fading > static_cast<double>(map.periods())) {
    result.reason =
        fmt::format("the slowest mode fades in {:.2g} periods: the motion may still settle", fading);
  } else if (fades(largest)) {
    result.reason = fmt::format(
        "small deviations fade, but no period is seen: it settles slowly, or repeats after more periods than "
        "are looked for: {}",
        further);
  } else if (largest.error > kTorusError) {
    result.reason = fmt::format("the sign of the largest Lyapunov exponent is within its error: {}", further);
  } else if (grown > kTorusGrowth) {
    result.reason =
        fmt::format("small deviations have grown by e^{:.2g}: a torus, or slow chaos: {}", grown, further);
  } else {
    result.verdict = LongRun::quasi_periodic;
  }
}

/// Whether nothing moves at an instant, nor any contact over the period.
bool is_still(const PeriodMap& map, const FlowState& at, std::span<const StopStatistics> stops,
              double length) {
  return map.scaled(at.state).tail(at.state.v.size()).lpNorm<Eigen::Infinity>() <= kStill &&
         std::ranges::all_of(stops, [length](const StopStatistics& stop) {
           return stop.x_max - stop.x_min <= kStill * length;
         });
}

class LongMotionFollower {
 public:
  LongMotionFollower(const ContactDynamics& dynamics, FlowState start, const LongMotionOptions& options,
                     const Deadline& deadline)
      : flow_(
            dynamics, kTolerance, [this] { return ended(); }, Integrator::modal),
        map_(flow_),
        state_(std::move(start)),
        options_(options),
        deadline_(deadline),
        limit_(deadline) {}

  LongMotion run() {
    try {
      std::optional<FixedPoint> orbit = settle();
      if (!orbit && !keeps_growing(sizes_, kLarge)) orbit = measure();
      if (orbit) measure_orbit(*orbit);
    } catch (const std::exception& error) {
      result_.reason = error.what();
    }
    // A stop that is far away makes the scale large: what grows there has not yet come to it.
    const bool torus = result_.verdict == LongRun::quasi_periodic;
    if (keeps_growing(sizes_, torus ? 0.0 : kLarge) && (torus || result_.verdict == LongRun::undecided))
      tell_growth();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool ended() const { return limit_.passed() || interrupted(); }

  /// The stable periodic motion that is reached, if one is, within its share of the time.
  std::optional<FixedPoint> settle() {
    constexpr double kShare = 0.4;  // of the time: the rest is for measuring
    limit_ = Deadline::first_of(deadline_, Deadline::after(kShare * std::max(0.0, deadline_.left())));
    std::optional<FixedPoint> found = settle_within_limit();
    limit_ = deadline_;
    return found;
  }

  /// Parts of the transient are each twice as long as the one before.
  std::optional<FixedPoint> settle_within_limit() {
    PeriodicMotionOptions options{
        .tolerance = kTolerance, .integrator = Integrator::modal, .max_order = options_.max_order};
    int part = 16;
    for (int marched = 0; marched < options_.transient; marched += part, part *= 2) {
      options.max_iterations = std::min(part, options_.transient - marched);
      FixedPoint found = march(map_, state_, options, [this] { return ended(); });
      state_ = found.start;
      if (found.converged) return found;
      if (limit_.passed()) break;
      sizes_.push_back(map_.scaled(state_.state).lpNorm<Eigen::Infinity>());
    }
    return std::nullopt;
  }

  /// The stable periodic motion that is reached since the motion is measured, if one is: looked for where
  /// small deviations fade and, not for long, where the last periods nearly repeat, as after a chaotic
  /// transient. The measurement goes on from where it is.
  std::optional<FixedPoint> settle_later(const LyapunovSum& deviations) {
    constexpr int kNotLong = 64;  // periods, or eight times the order
    const int highest = kHigher * options_.max_order;
    const std::optional<int> repeating = repeating_order(result_.section, highest);
    const bool faded = has_faded(deviations, map_.periods());
    if (!faded && !repeating) return std::nullopt;
    const int order = repeating.value_or(highest);
    const PeriodicMotionOptions options{
        .tolerance = kTolerance,
        .integrator = Integrator::modal,
        .max_iterations = faded ? static_cast<int>(result_.measured) : std::max(kNotLong, 8 * order),
        .max_order = faded ? highest : order};
    try {
      if (FixedPoint found = march(map_, state_, options, [this] { return ended(); }); found.converged)
        return found;
    } catch (const FlowError&) {  // what is measured remains
    }
    return std::nullopt;
  }

  /// Stops give no energy: where dampers take it from every mode, no motion is unbounded.
  void tell_growth() {
    const double fading = periods_to_fade(flow_.dynamics());
    result_.verdict = LongRun::undecided;
    result_.reason =
        fmt::format("after {} periods the state is {:.3g} times the scale of the motion, and grows",
                    map_.periods(), sizes_.back());
    if (fading > 0.0) {
      result_.reason += fmt::format("; it ends, for its slowest mode fades in {:.2g} periods", fading);
    } else {
      result_.verdict = LongRun::unbounded;
    }
  }

  /// Two turns of a periodic motion: what they differ by is the error of either.
  void measure_orbit(const FixedPoint& orbit) {
    const double period = orbit.order * map_.forcing_period();
    result_.settled_after = orbit.iterations;
    result_.section.clear();
    StopSums sums(flow_.dynamics().contact_count());
    FlowRecord turns[2];
    FlowState state = orbit.start;
    for (int n = 0; n < orbit.order; ++n) {
      FlowRecord unused;
      result_.section.push_back(section_of(flow_.dynamics(), state));
      map_.apply(state, 1, unused);
    }
    state = orbit.start;
    for (FlowRecord& turn : turns) {
      turn.dense = turn.tangent = true;
      map_.apply(state, orbit.order, turn);
      sums.take(turn, period);
    }
    result_.order = orbit.order;
    result_.measured = 2L * orbit.order;
    result_.stops = sums.statistics();
    if (turns[0].order_matters) {
      result_.reason = "no Lyapunov exponents: simultaneous impacts feel each other";
    } else {
      result_.lyapunov = exponents_of(turns, period, static_cast<std::size_t>(options_.exponents));
    }
    result_.trajectory = std::make_shared<EventTrajectory>(period, orbit.start, std::move(turns[0].nodes),
                                                           std::move(turns[0].events));
    // A load may be zero at the beginning of each period: neither there nor elsewhere does anything move.
    constexpr double kElsewhere = 0.2360679775;  // of a period
    FlowState later = orbit.start;
    FlowRecord unused;
    flow_.advance(later, kElsewhere * map_.forcing_period(), unused);
    const double length = flow_.dynamics().scales().displacement;
    const bool still =
        is_still(map_, orbit.start, result_.stops, length) && is_still(map_, later, result_.stops, length);
    result_.verdict = still ? LongRun::at_rest : LongRun::periodic;
  }

  /// Exponents and statistics of a motion that does not settle; else the periodic motion that it comes to.
  std::optional<FixedPoint> measure() {
    constexpr long kFirstLook = 500;  // periods until it is looked for; then each time after twice as many
    const ContactDynamics& dynamics = flow_.dynamics();
    const double period = map_.forcing_period();
    LyapunovSum deviations(dynamics.states(), options_.exponents);
    StopSums sums(dynamics.contact_count());
    bool order_matters = false;
    long next_look = std::min<long>(kFirstLook, options_.periods);
    // The section is that of t = 0, wherever the motion began.
    if (FlowRecord unused; state_.time > 0.0) {
      flow_.advance(state_, period - state_.time, unused);
      state_.time = 0.0;
    }
    while (result_.measured < options_.periods) {
      FlowRecord record;
      record.dense = record.tangent = true;
      record.derivative = deviations.frame();
      const FlowState before = state_;
      try {
        map_.apply(state_, 1, record);
      } catch (const FlowError&) {
        if (!deadline_.passed()) throw;
        state_ = before;
        break;
      }
      result_.section.push_back(section_of(dynamics, before));
      deviations.take(record.derivative);
      sums.take(record, period);
      order_matters = order_matters || record.order_matters;
      if (++result_.measured < next_look) continue;
      if (std::optional<FixedPoint> orbit = settle_later(deviations)) return orbit;
      next_look = std::min<long>(2 * next_look, options_.periods);
    }
    if (result_.measured > 0) result_.stops = sums.statistics();
    if (order_matters) {
      result_.reason = "simultaneous impacts feel each other: small deviations have no derivative";
    } else {
      decide(deviations, map_, options_, result_);
    }
    return std::nullopt;
  }

  EventFlow flow_;
  PeriodMap map_;
  FlowState state_;
  const LongMotionOptions& options_;
  const Deadline& deadline_;
  Deadline limit_;             // of what is being done
  std::vector<double> sizes_;  // of the state at the end of each part of the transient, in scales [-]
  LongMotion result_;
};

}  // namespace

LongMotion follow_long_motion(const ContactDynamics& dynamics, const FlowState& start,
                              const LongMotionOptions& options, const Deadline& deadline) {
  return LongMotionFollower(dynamics, start, options, deadline).run();
}

std::shared_ptr<const Trajectory> first_periods(const ContactDynamics& dynamics, const FlowState& start,
                                                int periods) {
  EventFlow flow(dynamics, kTolerance, interrupted, Integrator::modal);
  PeriodMap map(flow);
  FlowState state = start;
  FlowRecord record;
  record.dense = true;
  map.apply(state, periods, record);
  return std::make_shared<EventTrajectory>(periods * map.forcing_period(), start, std::move(record.nodes),
                                           std::move(record.events));
}

}  // namespace signorini
