#include "methods/orbit/arc_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "methods/solvers/bracketed_zero.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

LimitedSample sample(const LimitedOutput& f, double t) {
  return {.time = t, .value = f.value(t, 0), .rate = f.value(t, 1), .curvature = f.value(t, 2)};
}

// Local extreme between two instants, at one of which the value rises and at the other it falls.
double polished_peak(const LimitedOutput& f, double rises, double falls) {
  constexpr double kSettled = 1e-14;  // of the time
  const auto rate = [&](double t) { return ValueAndSlope{f.value(t, 1), f.value(t, 2)}; };
  const double middle = 0.5 * (rises + falls);
  const SignChange ends{.negative = falls, .positive = rises};
  return newton_zero_between(rate, ends, kSettled * std::abs(middle)).value_or(middle);
}

// Extremum of the rate between two samples whose curvatures have different signs. There the rate is flat: so
// near to it it is the extreme one to rounding.
LimitedSample steepest(const LimitedOutput& f, const LimitedSample& a, const LimitedSample& b) {
  constexpr double kNarrow = 1e-6;  // of the step
  const Bracket step{a.time, a.curvature, b.time, b.curvature};
  const auto curvature = [&](double t) { return f.value(t, 2); };
  return sample(f, bracketed_zero(curvature, step, kNarrow * (b.time - a.time)).value_or(step).a);
}

constexpr std::size_t kMostInstants = std::size_t{1} << 20U;  // 65,536 periods; 8 MB
constexpr double kAngle = kTwoPi / 16.0;                      // a step, in terms of the fastest rate left

// Instants from `begin` to `end`, both included, a step apart that resolves the fastest rate left, so many
// steps at least.
std::vector<double> instants(double begin, double end, const std::vector<FadingRate>& terms, int steps = 2) {
  std::vector<double> times{begin};
  for (double t = begin; t < end;) {
    const double next = t + std::min(kAngle / fastest_left(terms, t), (end - begin) / steps);
    t = next > t ? std::min(end, next) : end;  // an arc as short as rounding has no middle
    times.push_back(t);
    if (times.size() > kMostInstants)
      throw std::runtime_error(
          "an arc lasts too many periods of its fastest motion to be looked at between events");
  }
  return times;
}

// Where an output is among so many rows of LinearArc::outputs.
Eigen::Index row_of(const LimitedOutput& f, Eigen::Index rows) {
  if (!f.of_force) return f.contact;
  const std::vector<int>& closed = f.arc.mode().active;
  return rows - (closed.end() - std::ranges::find(closed, f.contact));
}

// Outputs of one arc at several instants, all of contacts that act, or all of open ones.
class SampledOutputs {
 public:
  SampledOutputs(std::span<const LimitedOutput> outputs, std::span<const double> times, int highest)
      : outputs_(outputs), rows_(outputs.size()) {
    const LinearArc& arc = outputs.front().arc;
    const int acting = arc.contact_count();
    if (outputs.front().contact < acting) {
      derivatives_ = arc.outputs(times, highest);
      for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = row_of(outputs[i], derivatives_[0].rows());
    } else {
      int first = outputs.front().contact, last = first;
      for (const LimitedOutput& f : outputs) {
        first = std::min(first, f.contact);
        last = std::max(last, f.contact);
      }
      derivatives_ = arc.open_displacements(times, highest, first - acting, last - first + 1);
      for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = outputs[i].contact - first;
    }
  }

  // Output i at instant k, or its derivative.
  [[nodiscard]] double value(std::size_t i, Eigen::Index k, int order) const {
    return outputs_[i].limited(derivatives_[static_cast<std::size_t>(order)](rows_[i], k), order);
  }

 private:
  std::span<const LimitedOutput> outputs_;
  std::vector<Eigen::Index> rows_;  // of each output
  std::vector<Eigen::MatrixXd> derivatives_;
};

// Instants whose outputs are evaluated at once.
constexpr std::size_t kTogether = 64;
std::span<const double> together(const std::vector<double>& times, std::size_t first) {
  return std::span(times).subspan(first, std::min(kTogether, times.size() - first));
}

constexpr double kNone = -std::numeric_limits<double>::infinity();

// What is not a number stays the peak.
void raise_to(LimitedSample& peak, const LimitedSample& other) {
  if (!std::isnan(peak.value) && !(other.value <= peak.value)) peak = other;
}

// Whether a maximum between two samples can be above zero: with samples as close as these it is no further
// above them than a quintic through values, rates and curvatures, several times over.
bool near_zero(const LimitedSample& a, const LimitedSample& b) {
  constexpr double kGrowth = 4.0;
  const double step = b.time - a.time;
  return !(std::max(a.value, b.value) + kGrowth * step *
                                            (std::max(std::abs(a.rate), std::abs(b.rate)) +
                                             step * std::max(std::abs(a.curvature), std::abs(b.curvature))) <
           0.0);
}

// The maximum between two samples, where there is one.
void raise_between(const LimitedOutput& f, const LimitedSample& a, const LimitedSample& b,
                   LimitedSample& peak) {
  const auto raise = [&](const LimitedSample& low, const LimitedSample& high) {
    if (!(low.rate > 0.0 && high.rate < 0.0)) return;
    const double top = polished_peak(f, low.time, high.time);
    raise_to(peak, {.time = top, .value = f.value(top, 0), .maximum = true});
  };
  if (!near_zero(a, b)) return;
  if (a.rate > 0.0 && b.rate < 0.0) {
    raise(a, b);
  } else if (a.curvature * b.curvature < 0.0) {
    // The rate turns in between: a bump too short for its signs at the samples, as after an impact at e = 0.
    const LimitedSample turn = steepest(f, a, b);
    raise(a, turn);
    raise(turn, b);
  }
}

// The maximum of a smooth function from its samples, with an estimate of what is between them: an eighth of
// the step squared times the curvature, that of the second differences on either side, several times over.
class BoundedMaximum {
 public:
  void take(double time, double value) {
    if (count_ >= 2) {
      const auto [t0, v0] = before_;
      const auto [t1, v1] = last_;
      const double curvature = 2.0 * ((value - v1) / (time - t1) - (v1 - v0) / (t1 - t0)) / (time - t0);
      const double step = std::max(time - t1, t1 - t0);
      const double bound = std::max({v0, v1, value}) + kSafety / 8.0 * step * step * std::abs(curvature);
      if (!std::isnan(bound_) && !(bound <= bound_)) bound_ = bound;
    }
    before_ = std::exchange(last_, {time, value});
    ++count_;
  }
  // Infinite with fewer than three samples; not a number where one is none.
  [[nodiscard]] double bound() const { return count_ < 3 ? -kNone : bound_; }

 private:
  static constexpr double kSafety = 8.0;

  std::pair<double, double> before_, last_;
  double bound_ = kNone;
  int count_ = 0;
};

}  // namespace

std::vector<LimitedOutput> near_limit(const std::vector<LimitedOutput>& outputs, double begin, double end,
                                      const std::vector<FadingRate>& terms) {
  constexpr double kUnseen = 1e-7, kLeast = 1e-4;
  constexpr int kSteps = 8;  // of fewer, one second difference may be zero where there is a maximum
  constexpr double kWorthwhile = 0.75;  // of the instants, which cost a little less without derivatives
  if (outputs.empty()) return outputs;
  const std::vector<double> times = instants(begin, end, outputs.front().arc.fading_rates(kUnseen), kSteps);
  const auto in_full = static_cast<double>(instants(begin, end, terms).size());
  if (static_cast<double>(times.size()) > kWorthwhile * in_full) return outputs;
  std::vector<BoundedMaximum> maxima(outputs.size());
  for (std::size_t first = 0; first < times.size(); first += kTogether) {
    const std::span<const double> some = together(times, first);
    const SampledOutputs samples(outputs, some, 0);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      for (Eigen::Index k = 0; k < std::ssize(some); ++k)
        maxima[i].take(some[static_cast<std::size_t>(k)], samples.value(i, k, 0));
    }
  }
  std::vector<LimitedOutput> near;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!(maxima[i].bound() + kLeast < 0.0)) near.push_back(outputs[i]);
  }
  return near;
}

std::vector<LimitedSample> largest(std::span<const LimitedOutput> outputs, double begin, double end,
                                   const std::vector<FadingRate>& terms) {
  std::vector<LimitedSample> peaks(outputs.size(), {.value = kNone}), before(outputs.size());
  if (outputs.empty()) return peaks;
  const std::vector<double> times = instants(begin, end, terms);
  for (std::size_t first = 0; first < times.size(); first += kTogether) {
    const std::span<const double> some = together(times, first);
    const SampledOutputs samples(outputs, some, 2);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      for (Eigen::Index k = 0; k < std::ssize(some); ++k) {
        const LimitedSample here{.time = some[static_cast<std::size_t>(k)],
                                 .value = samples.value(i, k, 0),
                                 .rate = samples.value(i, k, 1),
                                 .curvature = samples.value(i, k, 2)};
        raise_to(peaks[i], here);
        if (first > 0 || k > 0) raise_between(outputs[i], before[i], here, peaks[i]);
        before[i] = here;
      }
    }
  }
  return peaks;
}

std::vector<LimitedSample> extremes(const LimitedOutput& f, double begin, double end,
                                    const std::vector<FadingRate>& terms) {
  constexpr double kSafe = 0.99;
  std::vector<LimitedSample> found{{.time = begin, .value = f.value(begin, 0)}};
  const auto between = [&](const LimitedSample& a, const LimitedSample& b) {
    if (!(a.rate * b.rate < 0.0)) return;
    const bool falls = b.rate < 0.0;
    const double there = falls ? polished_peak(f, a.time, b.time) : polished_peak(f, b.time, a.time);
    found.push_back({.time = there, .value = f.value(there, 0), .maximum = falls, .minimum = !falls});
  };
  const auto at = [&](double t) { return LimitedSample{.time = t, .rate = f.value(t, 1)}; };
  LimitedSample before = at(begin);
  while (before.time < end) {
    const double t = before.time;
    const double fine = std::min(kAngle / fastest_left(terms, t), 0.5 * (end - begin));
    const double quiet = kSafe * std::abs(before.rate) / f.curvature_bound(t);
    const double next = t + std::max(fine, quiet);
    LimitedSample here = at(next > t ? std::min(end, next) : end);
    if (!(quiet > fine)) {
      before.curvature = f.value(t, 2);
      here.curvature = f.value(here.time, 2);
      const bool turns = before.curvature * here.curvature < 0.0 && before.rate * here.curvature > 0.0 &&
                         before.rate * here.rate > 0.0;
      if (turns) {  // towards zero and back again
        const LimitedSample turn = steepest(f, before, here);
        between(before, turn);
        between(turn, here);
      } else {
        between(before, here);
      }
    }
    before = here;
  }
  found.push_back({.time = end, .value = f.value(end, 0)});
  return found;
}

}  // namespace signorini
