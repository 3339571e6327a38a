#pragma once
// Newton's method with step halving, for any equations that can judge a step of it.

#include <concepts>
#include <optional>

#include "methods/deadline.hpp"

namespace signorini {

/// F(v) = 0 as damped_newton sees it. The equations keep the iterate v, the Newton step s and the last trial
/// v + t s; damped_newton decides on lengths t and on when to end.
template <class Equations>
concept NewtonEquations = requires(Equations& equations, double length) {
  // Whether v counts as a solution.
  { equations.solved() } -> std::convertible_to<bool>;
  // A norm of F at v, which every step must reduce.
  { equations.merit() } -> std::convertible_to<double>;
  // Finds s = -J^{-1} F at v and returns the longest t to try: 1, or less where v + s lies outside the
  // domain of F. Nothing where there is no such step: J is singular, or the equations refuse it.
  { equations.find_step() } -> std::convertible_to<std::optional<double>>;
  // The norm of F at the trial v + t s; nothing where F is not defined there.
  { equations.merit_at(length) } -> std::convertible_to<std::optional<double>>;
  // Makes the last trial the iterate.
  equations.accept();
};

/// When damped_newton gives up, and what it takes for progress.
struct DampedNewtonLimits {
  int max_steps = 100;    ///< steps begun [-]
  int max_halvings = 20;  ///< of each step [-]
  /// A trial of length t is accepted if its merit is below (1 - sufficient_decrease t) times that of the
  /// iterate: Armijo's condition on the norm, for which a Newton step predicts the decrease t. In (0, 1) [-]
  double sufficient_decrease = 1e-4;
  /// The end of the time budget, asked for before every step.
  Deadline deadline = {};
};

/// How damped_newton ended.
enum class NewtonEnd {
  solved,       ///< the equations call the iterate a solution
  limit,        ///< the steps are used up
  interrupted,  ///< the time budget is
  singular,     ///< the equations found no step
  stalled,      ///< no length tried reduces the merit by enough; the last trial is not accepted
};

/// What damped_newton did; the answer stays with the equations.
struct DampedNewtonResult {
  NewtonEnd end = NewtonEnd::limit;  ///< why it ended
  int steps = 0;                     ///< Newton steps found, one that stalls included
};

/// Solves F(v) = 0 by replacing v with v + t s, where s is the Newton step and t the first of the longest
/// length, its half, its quarter, ... that reduces the merit sufficiently. Where F is differentiable and J
/// regular, such a t exists; for the piecewise smooth equations of contact it may not, and then the end is
/// `stalled`. Source: [kelley1995, chapter 8].
template <NewtonEquations Equations>
DampedNewtonResult damped_newton(Equations& equations, const DampedNewtonLimits& limits) {
  for (int steps = 0;; ++steps) {
    if (equations.solved()) return {NewtonEnd::solved, steps};
    if (steps >= limits.max_steps) return {NewtonEnd::limit, steps};
    if (limits.deadline.passed()) return {NewtonEnd::interrupted, steps};
    const std::optional<double> longest = equations.find_step();
    if (!longest) return {NewtonEnd::singular, steps};
    const double merit = equations.merit();
    double length = *longest;
    bool descended = false;
    for (int halving = 0; halving <= limits.max_halvings && !descended; ++halving, length *= 0.5) {
      const std::optional<double> trial = equations.merit_at(length);
      // A merit that is not a number never descends.
      descended = trial && *trial < (1.0 - limits.sufficient_decrease * length) * merit;
    }
    if (!descended) return {NewtonEnd::stalled, steps + 1};
    equations.accept();
  }
}

}  // namespace signorini
