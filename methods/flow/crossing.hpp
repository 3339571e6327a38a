#pragma once
// Finds where a guard of the present mode fails within one step of the integrator.

#include <functional>
#include <optional>

namespace signorini {

/// A quantity that stays >= 0 as long as the mode lasts, and its time derivative.
struct Guard {
  double value = 0.0;
  double rate = 0.0;
};

/// What is known of a guard over a step.
struct GuardWindow {
  double begin = 0.0, end = 0.0;  ///< [s]
  bool fresh = false;  ///< true if the guard starts from zero (it has just closed, opened or rebounded)
  double floor = 0.0;  ///< a fresh guard may lie this far below zero: its noise (unit of the guard)
};

/// First time in (begin, end] at which the guard falls below zero, to round-off; empty if it does not.
///
/// Signs at the ends of the step are not enough: a guard that dips below zero and returns inside the
/// step (grazing) is found through its minimum, and a fresh one that rises and falls back inside the
/// step (a short rebound) through its maximum. A fresh guard is not reported at `begin`.
/// Assumes at most one extremum per half step, which a step resolved to tolerance satisfies.
std::optional<double> first_crossing(const std::function<Guard(double)>& guard, const GuardWindow& window);

}  // namespace signorini
