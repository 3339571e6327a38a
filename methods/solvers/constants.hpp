#pragma once
// Numbers that many solvers share.

#include <limits>
#include <numbers>

namespace signorini {

/// A turn [rad].
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// Distance from 1 to the next double [-].
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Rounding of a few dozen operations, relative [-].
inline constexpr double kSumRounding = 64.0 * kEpsilon;
/// What is smaller, relative to what it is a part or a difference of, is the rounding of a computed matrix
/// [-].
inline constexpr double kMatrixRounding = 1e-12;
/// A matrix of a smaller reciprocal condition is singular to rounding [-].
inline constexpr double kSingularCondition = 1e-13;
/// A residual of so many times the estimate of its rounding may be rounding: cancellation adds to it [-].
inline constexpr double kNoiseMargin = 100.0;
/// Beyond any number [-].
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace signorini
