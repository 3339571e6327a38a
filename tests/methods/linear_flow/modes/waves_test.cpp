#include "methods/linear_flow/modes/waves.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace signorini::waves_test {
namespace {

std::vector<double> harmonics_of(double base, int count) {
  std::vector<double> rates;
  for (int h = 0; h < count; ++h) rates.push_back(h * base);
  return rates;
}

TEST(Waves, KnowEvenRatesFromOthers) {
  std::vector<double> rates = harmonics_of(0.7, 40);
  EXPECT_TRUE(evenly_spaced(rates));
  rates[17] *= 1.0 + 1e-12;
  EXPECT_FALSE(evenly_spaced(rates));
  rates = harmonics_of(0.7, 40);
  rates.erase(rates.begin() + 5);
  EXPECT_FALSE(evenly_spaced(rates));
  EXPECT_FALSE(evenly_spaced({1.0, 2.0, 3.0}));
}

// The angle h base t is itself rounded to eps of it.
TEST(Waves, EqualSinesAndCosines) {
  for (const int count : {16, 33, 193}) {
    const std::vector<double> rates = harmonics_of(1150.0, count);
    for (const double time : {0.0, 1.3e-4, 0.0054, -0.0031}) {
      Eigen::VectorXcd wave(count);
      turn_evenly(rates, time, wave);
      for (int h = 0; h < count; ++h) {
        const double angle = rates[static_cast<std::size_t>(h)] * time;
        EXPECT_LT(std::abs(wave[h] - std::polar(1.0, angle)), 1e-15 * (2.0 + std::abs(angle)))
            << h << " " << time;
      }
    }
  }
}

}  // namespace
}  // namespace signorini::waves_test
