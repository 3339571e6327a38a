#include "methods/structure/periodic_green_function.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

namespace signorini {

PeriodicGreenFunction::PeriodicGreenFunction(ContactReceptance receptance)
    : receptance_(std::move(receptance)) {
  const double order = receptance_.harmonics();
  const Eigen::MatrixXcd& last = receptance_.receptance.back();
  inertance_ = -last.real() * order * order;
  drag_ = -last.imag() * order * order * order;
}

Jet PeriodicGreenFunction::at(int row, int column, double turn) const {
  constexpr double kPi = std::numbers::pi;
  const double theta = 2.0 * kPi * (turn - std::floor(turn));
  const std::complex<double> unit = std::polar(1.0, theta);
  std::complex<double> phase = 1.0;
  Jet sum{receptance_.receptance[0](row, column).real(), 0.0, 0.0};
  // Of sum over n > L of cos(n theta) / n^2 and its derivatives: the closed form less the first L terms.
  Jet tail{kPi * kPi / 6.0 - kPi * theta / 2.0 + theta * theta / 4.0,
           theta == 0.0 ? 0.0 : (theta - kPi) / 2.0, 0.5};
  for (int n = 1; n <= receptance_.harmonics(); ++n) {
    phase *= unit;
    const double order = n;
    const std::complex<double> term =
        2.0 * receptance_.receptance[static_cast<std::size_t>(n)](row, column) * phase;
    sum.value += term.real();
    sum.slope -= order * term.imag();
    sum.curvature -= order * order * term.real();
    tail.value -= phase.real() / (order * order);
    tail.slope += phase.imag() / order;
    tail.curvature += phase.real();
  }
  // The sum of b sin(n theta) / n^3 itself is of third order in 1 / L.
  const double a = 2.0 * inertance_(row, column);
  const double b = 2.0 * drag_(row, column);
  return {sum.value - a * tail.value, 2.0 * kPi * (sum.slope - a * tail.slope + b * tail.value),
          4.0 * kPi * kPi * (sum.curvature - a * tail.curvature + b * tail.slope)};
}

bool PeriodicGreenFunction::is_mass_beyond(int contact, int harmonics) const {
  constexpr double kLike = 0.5;
  const double a = inertance_(contact, contact);
  if (!(a > 0.0)) return false;
  for (int n = harmonics + 1; n <= receptance_.harmonics(); ++n) {
    const double order = n;
    const std::complex<double> c = receptance_.receptance[static_cast<std::size_t>(n)](contact, contact);
    if (!(std::abs(order * order * c + a) <= kLike * a)) return false;
  }
  return true;
}

}  // namespace signorini
