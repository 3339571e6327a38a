#include "methods/structure/periodic_green_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "methods/complementarity/projected_law.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini {
namespace {

using Complex = std::complex<double>;

// m = k = 1: T G(tau) = T Im(e^{mu tau} / (1 - e^{mu T})) / w_d, and its derivative with respect to tau / T.
struct OneMass {
  double damping = 0.1, period = 2.0 * std::numbers::pi / 2.2;

  [[nodiscard]] double at(double turn, int derivative) const {
    const double rate = std::sqrt(1.0 - 0.25 * damping * damping);
    const Complex mu(-0.5 * damping, rate);
    const Complex wave = std::exp(mu * turn * period) / (1.0 - std::exp(mu * period));
    return period * (std::pow(mu * period, derivative) * wave).imag() / rate;
  }
};

PeriodicGreenFunction response(int harmonics) {
  return PeriodicGreenFunction(
      fourier_receptance(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}), harmonics));
}

TEST(PeriodicGreenFunction, OfOneMassIsTheClosedForm) {
  const OneMass exact;
  // What is neglected falls like L^-3 for the value at an impulse, L^-2 for the slope.
  for (const int harmonics : {20, 80}) {
    const PeriodicGreenFunction found = response(harmonics);
    const double small = std::pow(harmonics, -3.0);
    for (const double turn : {0.0, 0.1, 0.5, 0.83, 1.1, -0.17}) {
      const double t = turn - std::floor(turn);
      const Jet jet = found.at(0, 0, turn);
      EXPECT_NEAR(jet.value, exact.at(t, 0), small) << "turn " << turn;
      // The slope jumps at the impulse itself, from its value at the period's end to that at its beginning.
      const double slope = t > 0.0 ? exact.at(t, 1) : 0.5 * (exact.at(0.0, 1) + exact.at(1.0, 1));
      EXPECT_NEAR(jet.slope, slope, 10.0 * small) << "turn " << turn;
      if (t == 0.0) continue;
      EXPECT_NEAR(jet.curvature, exact.at(t, 2), 2e3 * small) << "turn " << turn;
    }
  }
}

TEST(PeriodicGreenFunction, TellsAMassFromWhatAnswersOtherwise) {
  EXPECT_TRUE(response(20).is_mass_beyond(0, 10));
  const Problem compliant = test::massless_node();
  EXPECT_FALSE(PeriodicGreenFunction(fourier_receptance(compliant, 20)).is_mass_beyond(0, 10));
  // An eigenfrequency among the harmonics beyond.
  const Problem slow = test::to_problem({.damping = 0.1, .frequency = 0.07, .gap = 0.2});
  EXPECT_FALSE(PeriodicGreenFunction(fourier_receptance(slow, 20)).is_mass_beyond(0, 10));
}

}  // namespace
}  // namespace signorini
