#include "tests/reference/nonsmooth_bar.hpp"

#include <cmath>

namespace signorini::test {

namespace {

// f / a: slope -1 over a length of two, centred on 0, +1 over the rest of the period.
double wave(double s, double period) {
  const double turns = std::round(s / period);
  const double r = s - turns * period;
  return turns * (period - 4.0) + (std::abs(r) <= 1.0 ? -r : r - std::copysign(2.0, r));
}

}  // namespace

double NonsmoothBar::contact_duration() const { return 4.0 - period; }

double NonsmoothBar::strain() const { return gap / (2.0 * (period - 3.0)); }

double NonsmoothBar::energy() const { return 2.0 * strain() * strain(); }

double NonsmoothBar::force(double time) const {
  return std::abs(std::remainder(time, period)) <= 0.5 * contact_duration() ? -2.0 * strain() : 0.0;
}

double NonsmoothBar::u(double x, double time) const {
  const double s = time - 0.5 * period;
  return strain() * (wave(s + x, period) - wave(s - x, period));
}

}  // namespace signorini::test
