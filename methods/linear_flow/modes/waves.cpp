#include "methods/linear_flow/modes/waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "methods/solvers/constants.hpp"

namespace signorini {

bool evenly_spaced(const std::vector<double>& rates) {
  for (std::size_t h = 0; h < rates.size(); ++h) {
    const double even = static_cast<double>(h) * (rates.size() > 1 ? rates[1] : 0.0);
    if (!(std::abs(rates[h] - even) <= 4.0 * kEpsilon * even)) return false;
  }
  return true;
}

void turn_evenly(const std::vector<double>& rates, double time, Eigen::VectorXcd& wave) {
  constexpr Eigen::Index kApart = 16;
  std::array<std::complex<double>, kApart> turns;
  for (std::size_t j = 0; j < kApart; ++j) turns[j] = std::polar(1.0, rates[j] * time);
  for (Eigen::Index first = 0; first < wave.size(); first += kApart) {
    const std::complex<double> from = std::polar(1.0, rates[static_cast<std::size_t>(first)] * time);
    const Eigen::Index count = std::min(kApart, wave.size() - first);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::complex<double> by = turns[static_cast<std::size_t>(j)];
      wave[first + j] = {from.real() * by.real() - from.imag() * by.imag(),
                         from.real() * by.imag() + from.imag() * by.real()};
    }
  }
}

}  // namespace signorini
