#pragma once
// Continuation by natural parameter: from a problem that is solved to the one that is asked, in steps that
// adapt.

#include <algorithm>
#include <concepts>
#include <limits>

namespace signorini {

/// Steps along a path, in the measure of its parameter: shares of the way, or of a logarithm.
struct PathSteps {
  double first = 1.0;     ///< tried from the start
  double largest = 1.0;   ///< after any that was taken
  double smallest = 0.0;  ///< below which the path is given up
  double growth = 2.0;    ///< of a step after one that was taken; one that failed is halved
  int trials = std::numeric_limits<int>::max();  ///< steps that are tried, at most
};

/// Follows the solutions of a problem to that at the end of a path, each from the one before, where no arc
/// length is needed: a path that turns back in its parameter is lost at its fold.
/// \param advance  tries a step of this length from the last solution; true: it is the solution there now
/// \param reached  whether the last solution is that of the end
/// \param stopped  whether time or steps are spent, asked before each step
/// \return whether the end was reached
template <std::predicate<double> Advance, std::predicate Reached, std::predicate Stopped>
bool follow_path(const PathSteps& steps, Advance advance, Reached reached, Stopped stopped) {
  double step = steps.first;
  for (int trial = 0; trial < steps.trials && step >= steps.smallest && !reached() && !stopped(); ++trial)
    step = advance(step) ? std::min(steps.largest, steps.growth * step) : 0.5 * step;
  return reached();
}

}  // namespace signorini
