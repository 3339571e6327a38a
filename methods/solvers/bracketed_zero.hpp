#pragma once
// A zero of a function of one variable: between two places where its signs differ, or near a guess.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "methods/solvers/constants.hpp"

namespace signorini {

/// Steps between two places that differ in the sign of f before bisection alone [-].
inline constexpr int kSuperlinearSteps = 40;

/// Two places, in any order, and f there.
struct Bracket {
  double a = 0.0;    ///< one place
  double f_a = 0.0;  ///< f(a)
  double b = 0.0;    ///< the other place
  double f_b = 0.0;  ///< f(b)
};

/// Solves f(t) = 0 between two places where f has different signs, or is zero at one of them. An iterate is
/// the zero of the inverse parabola through the last three points where that is monotone between them, and
/// the middle of the bracket elsewhere; it takes the place where f has its sign. It stays one tolerance away
/// from both places, so that the bracket becomes narrow from both sides. The first iterate is that of a
/// secant. Source: [chandrupatla1997], which begins in the middle.
///
/// Guaranteed for every f, whether it is continuous or not: f changes its sign within the result, which takes
/// at most 40 evaluations more than bisection. A simple zero takes 4 to 13.
///
/// \param tolerance  width of the bracket that ends the search; rounding of its places, if that is more
/// \return the last bracket: either f_a = 0, or both places are within the tolerance and `a` was evaluated
///         last. A bracket that needs no search is returned with a zero, if it has one, as `a`. Empty where
///         the signs do not differ, and where f is not a number.
template <class Function>
std::optional<Bracket> bracketed_zero(Function&& f, Bracket bracket, double tolerance) {
  auto& [a, f_a, b, f_b] = bracket;
  if (!((f_a <= 0.0 && f_b >= 0.0) || (f_a >= 0.0 && f_b <= 0.0))) return std::nullopt;
  if (f_b == 0.0) {
    std::swap(a, b);
    std::swap(f_a, f_b);
  }
  double share = f_a / (f_a - f_b);  // of the way from a to b
  for (int k = 1; f_a != 0.0; ++k) {
    const double shortest = std::max(tolerance, kEpsilon * std::max(std::abs(a), std::abs(b)));
    const double least = shortest / std::abs(b - a);
    if (!(least < 1.0)) break;
    const double t = a + (least < 0.5 ? std::min(std::max(least, share), 1.0 - least) : 0.5) * (b - a);
    const double value = f(t);
    if (std::isnan(value)) return std::nullopt;
    double c = a, f_c = f_a;  // what the new bracket leaves out
    if ((value > 0.0) != (f_a > 0.0)) {
      std::swap(b, c);
      std::swap(f_b, f_c);
    }
    a = t;
    f_a = value;
    const double x = (a - b) / (c - b), y = (f_a - f_b) / (f_c - f_b);
    const bool monotone = y * y < x && (1.0 - y) * (1.0 - y) < 1.0 - x;
    share = monotone && k < kSuperlinearSteps ? f_a / (f_b - f_a) * f_c / (f_b - f_c) +
                                                    (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b)
                                              : 0.5;
  }
  return bracket;
}

/// f and its derivative at one place.
struct ValueAndSlope {
  double value = 0.0;  ///< f(t)
  double slope = 0.0;  ///< f'(t)
};

/// Two places, in any order, between which f changes its sign.
struct SignChange {
  double negative = 0.0;  ///< where f < 0
  double positive = 0.0;  ///< where f > 0
};

/// Solves f(t) = 0 between two places where f has different signs, by Newton's method from the middle between
/// them [kelley1995, chapter 5]. An iterate takes the place where f has its sign; a step that leads out of
/// the bracket is replaced by one to its middle, and so is every step after the 40th.
///
/// Guaranteed for every f with this derivative: the last step is no longer than the tolerance, after at most
/// 40 evaluations more than bisection takes. A simple zero takes 4 to 10.
///
/// \param f          returns .value and .slope
/// \param tolerance  length of the step that is the last; rounding of the iterate, if that is more
/// \return the end of the last step. Empty where f is not a number.
template <class Function>
std::optional<double> newton_zero_between(Function&& f, SignChange places, double tolerance) {
  auto& [negative, positive] = places;
  double t = 0.5 * (negative + positive);
  for (int k = 0;; ++k) {
    const auto there = f(t);
    if (std::isnan(there.value)) return std::nullopt;
    if (there.value == 0.0) return t;
    (there.value > 0.0 ? positive : negative) = t;
    const double settled = std::max(tolerance, kEpsilon * std::abs(t));
    double next = t - there.value / there.slope;
    const bool inside = (next - negative) * (next - positive) < 0.0 || std::abs(next - t) <= settled;
    if (k >= kSuperlinearSteps || !inside) next = 0.5 * (negative + positive);
    if (std::abs(next - t) <= settled) return next;
    t = next;
  }
}

/// Where newton_zero_near begins and when it ends, in the unit of t.
struct NewtonSearch {
  double guess = 0.0;           ///< the first iterate
  double reach = 0.0;           ///< how far from the guess iterates may be
  double settled = 0.0;         ///< a step as short as this, or as rounding of t, is the last
  double accepted = kInfinity;  ///< the last step of 20 must be as short as this
};

/// Solves f(t) = 0 near a guess, where no change of sign is known, by at most 20 steps of Newton's method
/// [kelley1995, chapter 5]. Guaranteed is only that all iterates are within reach of the guess.
///
/// \param f  returns .value and .slope; a slope that is not a number ends the search
/// \return the end of the last step. Empty where a step leads out of reach or is not a number, and where the
///         last one is longer than `accepted`.
template <class Function>
std::optional<double> newton_zero_near(Function&& f, const NewtonSearch& search) {
  constexpr int kSteps = 20;
  double t = search.guess, step = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const auto there = f(t);
    step = -there.value / there.slope;
    t += step;
    if (!(std::abs(t - search.guess) <= search.reach)) return std::nullopt;
    if (std::abs(step) <= std::max(search.settled, 2.0 * kEpsilon * std::abs(t))) break;
  }
  return std::abs(step) <= search.accepted ? std::optional(t) : std::nullopt;
}

}  // namespace signorini
