#pragma once
// Closed-form oracle: periodic orbits of the forced one-mass impact oscillator that touch the stop once.

#include <complex>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// m x'' + c x' + k x = P0 + F cos(w t), x <= g, x'_+ = -e x'_-; one impact every `order` forcing periods.
struct ImpactOscillator {
  double mass = 1.0;         ///< m [kg]
  double damping = 0.1;      ///< c [N s/m], below critical
  double stiffness = 1.0;    ///< k [N/m]
  double load = 1.0;         ///< F [N]
  double frequency = 1.0;    ///< w [rad/s]
  double gap = 0.0;          ///< g [m]
  double restitution = 1.0;  ///< e [-]
  int order = 1;             ///< n, forcing periods per impact [-]
  double static_load = 0.0;  ///< P0 [N]
};

/// One such orbit. Times are those of the forcing, in [0, period).
struct SingleImpactOrbit {
  ImpactOscillator oscillator = {};
  double period = 0.0;       ///< n 2 pi / w [s]
  double impact_time = 0.0;  ///< t0 [s]
  double approach = 0.0;     ///< x'(t0-) > 0 [m/s]
  double impulse = 0.0;      ///< J = m (1 + e) x'(t0-) > 0, acting on the mass towards -x [N s]
  double trace = 0.0;        ///< of the monodromy over one period [-]
  double determinant = 0.0;  ///< of the monodromy, e^2 exp(-c period / m) [-]

  [[nodiscard]] double x(double time) const;         ///< [m]
  [[nodiscard]] double velocity(double time) const;  ///< right-sided at the impact [m/s]
  /// Coefficient n of x(t) = sum_n x_n exp(i n 2 pi t / period), exact for every n [m].
  [[nodiscard]] std::complex<double> fourier(int n) const;
  /// Both multipliers inside the unit circle: |trace| < 1 + determinant < 2.
  [[nodiscard]] bool stable() const;

  // x = exp(-decay s)(amplitude_cos cos wd s + amplitude_sin sin wd s) + P0/k + X cos(w s + phase), s = t -
  // t0
  double amplitude_cos = 0.0, amplitude_sin = 0.0, forced_amplitude = 0.0, phase = 0.0;
};

/// Every admissible orbit (closing speed > 0, x <= g between impacts): none, one or two of them, the
/// one of larger closing speed first. Needs c < 2 sqrt(k m) and sin(wd period) != 0. Closed form (the
/// free flight of a linear oscillator joined to itself by the impact law), no time stepping.
std::vector<SingleImpactOrbit> single_impact_orbits(const ImpactOscillator& oscillator);

/// The same oscillator as a scene for the methods.
Problem to_problem(const ImpactOscillator& oscillator);

}  // namespace signorini::test
