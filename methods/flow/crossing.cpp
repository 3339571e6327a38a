#include <algorithm>
#include <cmath>

#include "methods/flow/stretch.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

struct Sample {
  double time = 0.0;
  Guard guard = {};
};

using Function = std::function<double(const Guard&)>;

// Zero of `f`, positive at `a` and not positive at `b`: regula falsi in Illinois form with
// bisections in between, down to neighbouring numbers. Returns the end that is not positive.
double zero_between(const std::function<Guard(double)>& guard, const Function& f, const Sample& a,
                    const Sample& b) {
  double low = a.time, high = b.time, f_low = f(a.guard), f_high = f(b.guard);
  // Regula falsi keeps one end for ever where f is curved. Illinois: the value of an end that stays twice in
  // a row counts half, which makes the order 1.44; every eighth step halves the bracket whatever happens.
  constexpr int kIterations = 200;
  int moved_before = 0;  // which end moved last: -1 low, +1 high
  for (int k = 0; k < kIterations && f_high != 0.0; ++k) {
    if (std::abs(high - low) <= 2.0 * kEpsilon * std::max(std::abs(low), std::abs(high))) break;
    double middle = high - f_high * (high - low) / (f_high - f_low);
    if (k % 8 == 7 || !((middle - low) * (middle - high) < 0.0)) middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    const double value = f(guard(middle));
    const int moved = value > 0.0 ? -1 : 1;
    (moved < 0 ? low : high) = middle;
    (moved < 0 ? f_low : f_high) = value;
    if (moved == moved_before) (moved < 0 ? f_high : f_low) *= 0.5;
    moved_before = moved;
  }
  return high;
}

double value_of(const Guard& guard) { return guard.value; }
double rise_of(const Guard& guard) { return guard.rate; }
double fall_of(const Guard& guard) { return -guard.rate; }

// A guard clearly above zero at `a`.
std::optional<double> armed_crossing(const std::function<Guard(double)>& guard, const Sample& a,
                                     const Sample& b) {
  if (b.guard.value < 0.0) {
    return a.guard.value > 0.0 ? zero_between(guard, value_of, a, b) : a.time;
  }
  if (a.guard.rate < 0.0 && b.guard.rate > 0.0) {
    const double time = zero_between(guard, fall_of, a, b);
    const Sample lowest{time, guard(time)};
    if (lowest.guard.value < 0.0 && a.guard.value > 0.0) return zero_between(guard, value_of, a, lowest);
  }
  return std::nullopt;
}

// A guard that left zero at the start and has not risen above its noise by `a`.
std::optional<double> fresh_crossing(const std::function<Guard(double)>& guard, const Sample& a,
                                     const Sample& b, double floor) {
  if (b.guard.value >= 0.0) return std::nullopt;
  if (a.guard.rate > 0.0 && b.guard.rate < 0.0) {
    const double time = zero_between(guard, rise_of, a, b);
    const Sample highest{time, guard(time)};
    if (highest.guard.value > 0.0) return zero_between(guard, value_of, highest, b);
  }
  if (b.guard.value >= -floor) return std::nullopt;
  if (a.guard.value <= -floor) return b.time;
  const Function above_floor = [floor](const Guard& g) { return g.value + floor; };
  return zero_between(guard, above_floor, a, b);
}

}  // namespace

std::optional<double> first_crossing(const std::function<Guard(double)>& guard, const GuardWindow& window) {
  const double middle = 0.5 * (window.begin + window.end);
  const Sample nodes[] = {
      {window.begin, guard(window.begin)}, {middle, guard(middle)}, {window.end, guard(window.end)}};
  bool fresh = window.fresh;
  for (int i = 0; i < 2; ++i) {
    const Sample &a = nodes[i], &b = nodes[i + 1];
    const auto found = fresh ? fresh_crossing(guard, a, b, window.floor) : armed_crossing(guard, a, b);
    if (found) return found;
    if (b.guard.value > window.floor) fresh = false;
  }
  return std::nullopt;
}

}  // namespace signorini
