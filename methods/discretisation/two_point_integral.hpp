#pragma once
// The integral of a function whose derivatives are known at both ends.

#include <array>
#include <cstddef>

namespace signorini {

/// f, f', ..., f'''' at one instant.
using Derivatives = std::array<double, 5>;

/// Integral over [0, h] of the polynomial of degree 9 that has these derivatives at 0 and h,
///
///     sum_k c_k h^(k+1) (f_k(0) + (-1)^k f_k(h)),   c_k = binomial(5, k + 1) (9 - k)! / 10!.
///
/// Of a function f the error is 5!^2 / (10! 11!) h^11 max |f^(10)| at most: 1e-8 of the integral of a
/// half-wave of a sine cut in two, 1e-11 if cut in four.
inline double two_point_integral(double h, const Derivatives& left, const Derivatives& right) {
  constexpr std::array kWeights{1.0 / 2.0, 1.0 / 9.0, 1.0 / 72.0, 1.0 / 1008.0, 1.0 / 30240.0};
  double integral = 0.0, power = h, sign = 1.0;
  for (std::size_t k = 0; k < left.size(); ++k) {
    integral += kWeights[k] * power * (left[k] + sign * right[k]);
    power *= h;
    sign = -sign;
  }
  return integral;
}

}  // namespace signorini
