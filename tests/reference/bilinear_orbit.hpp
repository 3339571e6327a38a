#pragma once
// Closed-form oracle: periodic orbits of the forced one-mass oscillator with a spring stop.

#include <complex>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// m x'' + c x' + k x = P0 + F cos(w t) - eps max(0, x - g), one contact interval per forcing period.
/// Each phase is a damped linear oscillator, solved in closed form.
struct BilinearOrbit {
  ImpactOscillator oscillator = {};  ///< restitution and order unused
  double penalty = 0.0;              ///< eps [N/m]
  double close = 0.0;                ///< t1, in [0, period) [s]
  double open = 0.0;                 ///< t2 in (t1, t1 + period) [s]
  double approach = 0.0;             ///< x'(t1) > 0 [m/s]
  double mismatch = 0.0;             ///< what is missing to periodicity, relative to `approach` [-]

  [[nodiscard]] double period() const;
  [[nodiscard]] double x(double time) const;         ///< [m]
  [[nodiscard]] double velocity(double time) const;  ///< [m/s]
  /// Coefficient n of x(t) = sum_n x_n e^{i n w t}, exact [m].
  [[nodiscard]] std::complex<double> fourier(int n) const;
  /// Largest x - g [m].
  [[nodiscard]] double penetration() const;
  /// Trace of the monodromy, the product of the two phases' flows [-].
  [[nodiscard]] double trace() const;
};

/// Newton on the two switching times and the speed of approach.
/// \throws std::runtime_error if it does not settle
BilinearOrbit bilinear_orbit(const ImpactOscillator& oscillator, double penalty, double close, double open,
                             double approach);

/// The same, followed down from the rigid orbit of restitution 1: for a stiff stop the two are near, and
/// each softer stop starts from the stiffer one before it.
BilinearOrbit bilinear_orbit_of(const SingleImpactOrbit& rigid, double penalty);

}  // namespace signorini::test
