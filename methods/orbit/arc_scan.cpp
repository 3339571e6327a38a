#include "methods/orbit/arc_scan.hpp"

#include <algorithm>
#include <cmath>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

LimitedSample sample(const LimitedOutput& f, double t) {
  return {.time = t, .value = f.value(t, 0), .rate = f.value(t, 1), .curvature = f.value(t, 2)};
}

// Local extreme between two instants where the rate falls through zero, or rises.
double polished_peak(const LimitedOutput& f, double low, double high, bool falls = true) {
  // Newton's method on the rate, in a bracket that shrinks with every iterate and is halved where a step
  // leaves it.
  double t = 0.5 * (low + high);
  for (int k = 0; k < 30; ++k) {
    const double rate = f.value(t, 1), curvature = f.value(t, 2);
    ((rate > 0.0) == falls ? low : high) = t;
    double next = t - rate / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-14 * std::abs(t)) break;
    t = next;
  }
  return t;
}

// Extremum of the rate between two samples on either side of it.
LimitedSample steepest(const LimitedOutput& f, double low, double high) {
  constexpr int kBisections = 40;
  const bool falls = f.value(low, 2) < 0.0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    ((f.value(middle, 2) < 0.0) == falls ? low : high) = middle;
  }
  return sample(f, 0.5 * (low + high));
}

}  // namespace

std::vector<LimitedSample> scan(const LimitedOutput& f, double begin, double end,
                                const std::vector<FadingRate>& terms) {
  constexpr double kAngle = kTwoPi / 16.0;  // a step, in terms of the fastest rate left
  LimitedSample before = sample(f, begin);
  std::vector<LimitedSample> samples{before};
  const auto rise = [&](const LimitedSample& a, const LimitedSample& b) {
    if (!(a.rate > 0.0 && b.rate < 0.0)) return;
    const double top = polished_peak(f, a.time, b.time);
    samples.push_back({.time = top, .value = f.value(top, 0), .maximum = true});
  };
  for (double t = begin; t < end;) {
    const double next = t + std::min(kAngle / fastest_left(terms, t), 0.5 * (end - begin));
    t = next > t ? std::min(end, next) : end;  // an arc as short as rounding has no middle
    const LimitedSample here = sample(f, t);
    samples.push_back(here);
    if (before.rate > 0.0 && here.rate < 0.0) {
      rise(before, here);
    } else if (before.curvature * here.curvature < 0.0) {
      // The rate turns in between: a bump too short for its signs at the samples, as after an impact at e =
      // 0.
      const LimitedSample turn = steepest(f, before.time, t);
      rise(before, turn);
      rise(turn, here);
    }
    before = here;
  }
  return samples;
}

std::vector<LimitedSample> extremes(const LimitedOutput& f, double begin, double end,
                                    const std::vector<FadingRate>& terms) {
  constexpr double kAngle = kTwoPi / 16.0;  // a step, in terms of the fastest rate left
  constexpr double kSafe = 0.99;
  std::vector<LimitedSample> found{{.time = begin, .value = f.value(begin, 0)}};
  const auto between = [&](const LimitedSample& a, const LimitedSample& b) {
    if (!(a.rate * b.rate < 0.0)) return;
    const bool falls = b.rate < 0.0;
    const double there = polished_peak(f, a.time, b.time, falls);
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
      const double first = f.value(t, 2), last = f.value(here.time, 2);
      const bool turns = first * last < 0.0 && before.rate * last > 0.0 && before.rate * here.rate > 0.0;
      if (turns) {  // towards zero and back again
        const LimitedSample turn = steepest(f, t, here.time);
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
