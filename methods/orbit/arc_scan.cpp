#include "methods/orbit/arc_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

// The outputs of one arc, all of contacts that act or all of open ones, at instants that are evaluated some
// at once: `take` has the number of an output and its sample with the derivatives asked for, each output's in
// the order of time.
template <class Take>
void sample_all(std::span<const LimitedOutput> outputs, const std::vector<double>& times, int derivatives,
                const Take& take) {
  constexpr std::size_t kTogether = 64;
  const LinearArc& arc = outputs.front().arc;
  const int acting = arc.contact_count();
  const auto [low, high] = std::ranges::minmax_element(outputs, {}, &LimitedOutput::contact);
  const int first = low->contact, count = high->contact - first + 1;
  const bool open = first >= acting;
  const auto row_of = [&](const LimitedOutput& f) -> Eigen::Index {
    const std::vector<int>& closed = arc.mode().active;
    if (f.of_force) return acting + (std::ranges::find(closed, f.contact) - closed.begin());
    return open ? f.contact - first : f.contact;
  };
  for (std::size_t begin = 0; begin < times.size(); begin += kTogether) {
    const auto some = std::span(times).subspan(begin, std::min(kTogether, times.size() - begin));
    const std::vector<Eigen::MatrixXd> values =
        open ? arc.open_displacements(some, derivatives, first - acting, count)
             : arc.outputs(some, derivatives);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const Eigen::Index row = row_of(outputs[i]);
      for (std::size_t k = 0; k < some.size(); ++k) {
        std::array<double, 3> at{};
        for (std::size_t order = 0; order < values.size(); ++order)
          at[order] =
              outputs[i].limited(values[order](row, static_cast<Eigen::Index>(k)), static_cast<int>(order));
        take(i, LimitedSample{.time = some[k], .value = at[0], .rate = at[1], .curvature = at[2]});
      }
    }
  }
}

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
  [[nodiscard]] double bound() const { return count_ < 3 ? kInfinity : bound_; }

 private:
  static constexpr double kSafety = 8.0;

  std::pair<double, double> before_, last_;
  double bound_ = -kInfinity;
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
  sample_all(outputs, times, 0,
             [&](std::size_t i, const LimitedSample& at) { maxima[i].take(at.time, at.value); });
  std::vector<LimitedOutput> near;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!(maxima[i].bound() + kLeast < 0.0)) near.push_back(outputs[i]);
  }
  return near;
}

std::vector<LimitedSample> largest(std::span<const LimitedOutput> outputs, double begin, double end,
                                   const std::vector<FadingRate>& terms) {
  std::vector<LimitedSample> peaks(outputs.size(), {.value = -kInfinity}), before(outputs.size());
  if (outputs.empty()) return peaks;
  sample_all(outputs, instants(begin, end, terms), 2, [&](std::size_t i, const LimitedSample& here) {
    raise_to(peaks[i], here);
    if (here.time > begin) raise_between(outputs[i], before[i], here, peaks[i]);
    before[i] = here;
  });
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
    found.push_back({.time = there, .value = f.value(there, 0), .maximum = falls});
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
