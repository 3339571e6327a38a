#pragma once
// Oracle: a bar without distortion (Heaviside's condition), exact in time and in frequency.

#include <vector>

#include "methods/structure/receptance.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// u_tt + 2 alpha u_t + alpha^2 u = u_xx on 0 < x < 1, u(0) = 0, u_x(1) = F cos(2 pi t / T) + lambda,
/// u(1) <= g: length, wave speed and EA are one. The set B-1 of the design's oracles.
struct DistortionlessBar {
  double decay = 0.1;   ///< alpha [-]
  double load = 1.0;    ///< F [-]
  double gap = 0.5;     ///< g [-]
  double period = 5.0;  ///< T [-]
};

/// Periodic motion of the tip on a grid, by the method of characteristics.
struct TipMotion {
  double period = 0.0;
  std::vector<double> u, lambda;  ///< at times i * period / size
  double impulse = 0.0;           ///< -integral of lambda over a period
};

/// With p = u_t + alpha u the invariants p +- u_x decay by e^{-alpha t} along the characteristics, so that at
/// the tip w(t) = p - u_x = -e^{-2 alpha} (p + u_x)(t - 2). Free: u_x = F cos, p = w + u_x; in contact p =
/// alpha g, u_x = p - w, lambda = u_x - F cos. Explicit, exact but for the rounding of contact times to the
/// grid: first order in the step. Marched for `periods` from rest.
/// \param steps_per_unit  grid points per unit of time, >= 2
TipMotion tip_motion(const DistortionlessBar& bar, int steps_per_unit, int periods);

/// The exact receptance of the tip, C_n = tanh(k_n) / k_n with k_n = alpha + i n 2 pi / T, n = 0..H.
ContactReceptance tip_receptance(const DistortionlessBar& bar, int harmonics);

/// The same bar by `elements` linear finite elements, D = 2 alpha M and K + alpha^2 M, its tip massless.
Problem finite_element_bar(const DistortionlessBar& bar, int elements);

}  // namespace signorini::test
