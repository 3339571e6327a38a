#include "methods/discretisation/symbols.hpp"

#include <cmath>

namespace signorini {

HarmonicWeights exact_weights(double w) { return {{-w * w, 0.0}, {0.0, w}, {1.0, 0.0}, 1.0}; }

HarmonicWeights scheme_weights(HatScheme scheme, double theta, double step) {
  if (scheme == HatScheme::backward) {
    const std::complex<double> s = (1.0 - std::polar(1.0, -theta)) / step;
    return {s * s, s, 1.0, 1.0};
  }
  if (scheme == HatScheme::bdf2) {
    // 3 - 4 z + z^2 = (1 - z) (3 - z); 1 - z by the half angle, as below.
    const std::complex<double> z = std::polar(1.0, -theta);
    const double half = std::sin(0.5 * theta);
    const std::complex<double> s =
        std::complex<double>(2.0 * half * half, std::sin(theta)) * (3.0 - z) / (2.0 * step);
    return {s * s, s, 1.0, 1.0};
  }
  // 2 - 2 cos theta = 4 sin^2(theta / 2): the half angle keeps its digits at low harmonics, where the
  // difference would lose those that the inertia of a fine grid needs.
  const double half = std::sin(0.5 * theta);
  const double gram = scheme == HatScheme::nodal ? 1.0 : 1.0 - 2.0 * half * half / 3.0;
  return {-4.0 * half * half / (step * step), std::complex<double>(0.0, std::sin(theta) / step), gram, gram};
}

double contact_force_weight(HatScheme scheme, double theta) {
  return scheme == HatScheme::consistent ? (2.0 + std::cos(theta)) / 3.0 : 1.0;
}

std::complex<double> restitution_shift(const std::optional<double>& e, double theta) {
  if (!e) return 1.0;
  const std::complex<double> ahead = std::polar(1.0, theta);
  return (ahead + *e * std::conj(ahead)) / (1.0 + *e);
}

}  // namespace signorini
