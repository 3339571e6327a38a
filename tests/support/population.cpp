#include "tests/support/population.hpp"

#include <cmath>
#include <random>

namespace signorini::test {

std::vector<ImpactOscillator> contact_population(int count, unsigned long seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    constexpr double kRange = 18446744073709551616.0;  // 2^64
    return low + (high - low) * (static_cast<double>(random()) / kRange);
  };
  std::vector<ImpactOscillator> population;
  while (static_cast<int>(population.size()) < count) {
    const double damping = std::pow(10.0, uniform(-2.5, -0.5));
    const double gap = uniform(-0.5, 1.0);
    const double frequency = uniform(0.4, 3.0);
    const double amplitude = 1.0 / std::hypot(1.0 - frequency * frequency, damping * frequency);
    if (amplitude > gap) population.push_back({.damping = damping, .frequency = frequency, .gap = gap});
  }
  return population;
}

}  // namespace signorini::test
