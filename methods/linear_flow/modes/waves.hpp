#pragma once
// Complex exponentials: of many harmonics at an instant, and of modes that fade.

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace signorini {

/// Whether e^{mu duration} is below e^-50, so that nothing is left of a mode.
inline bool has_faded(std::complex<double> mu, double duration) {
  return mu.real() < 0.0 && mu.real() * duration < -50.0;
}

/// Whether the rates are 0, r, 2 r, ... to rounding.
bool evenly_spaced(const std::vector<double>& rates);

/// wave_h = e^{i rate_h t} of 16 or more rates, evenly spaced: a sine of every sixteenth, and products with
/// those of the first sixteen between. To three roundings of the angle's own.
void turn_evenly(const std::vector<double>& rates, double time, Eigen::VectorXcd& wave);

}  // namespace signorini
