#pragma once
// Oracle: motions without impacts made first, and the loads that cause them afterwards.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// One contact that rests on its stop for a part of the period. In turns s in [0, 1) of the period
///
///     x = g - depth sin^p(pi (s - close - rest) / (1 - rest))  in free flight,  x = g at rest,
///     lambda = -push sin^q(pi (s - close) / rest)              at rest,         lambda = 0 in free flight.
///
/// For p >= 2 the stop is met and left at speed zero: no impact. At both ends of the rest x^(p) and
/// lambda^(q) jump, and the Fourier coefficients fall like n^-(p+1) and n^-(q+1).
struct RestingContact {
  double gap = 0.1;    ///< g [m]
  double close = 0.0;  ///< where the rest begins [-]
  double rest = 0.3;   ///< its part of the period, in (0, 1) [-]
  double depth = 1.0;  ///< [m]
  double push = 1.0;   ///< [N]

  [[nodiscard]] double x(double turns, int p) const;
  [[nodiscard]] double lambda(double turns, int q) const;
  /// Coefficients n >= 0 of the complex Fourier series, exact.
  [[nodiscard]] std::complex<double> x_coefficient(int n, int p) const;
  [[nodiscard]] std::complex<double> lambda_coefficient(int n, int q) const;
};

/// Six coordinates between springs, three contacts: two on one coordinate each, one on a distance. The others
/// move harmonically. The contacts carry mass, or none; without it the structure determines the motion, with
/// it only if the stops absorb impacts, e = 0.
struct ManufacturedChain {
  int p = 3;  ///< see RestingContact
  int q = 2;
  bool massless = true;
  double restitution = 0.0;  ///< of contacts with mass

  [[nodiscard]] static std::vector<RestingContact> contacts();
  /// f = M u'' + D u' + K u - W lambda, harmonics 0..highest.
  [[nodiscard]] Problem problem(int highest) const;
};

}  // namespace signorini::test
