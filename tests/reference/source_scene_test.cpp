// The scene of section 3 of the source paper [shi2015], sdof-source-paper, against its exact orbit.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::source_scene_test {
namespace {

using Complex = std::complex<double>;
using test::solve;

const Problem& scene() {
  static const Problem problem = load_scene(find_scene("sdof-source-paper"));
  return problem;
}

test::ImpactOscillator oscillator() {
  return {.mass = scene().mass().coeff(0, 0),
          .damping = scene().damping().coeff(0, 0),
          .stiffness = scene().stiffness().coeff(0, 0),
          .load = scene().force.at(0).cos,
          .frequency = scene().frequency,
          .gap = scene().contacts.at(0).gap,
          .restitution = std::get<Restitution>(scene().law()).e};
}

struct ImpactOrbit {
  double time = 0.0;     // of the impact [s]
  double impulse = 0.0;  // [N s]
};

// x = x_f - J G(t - t0), G the T-periodic response to a unit impulse, x_f = Re(e^{iwt} / Z). With gap 0 and
// e = 1 the impact asks x_f(t0) = J G(0) and x_f'(t0) = J G'(0), G' the mean of both sides. Of
// x_f = |1/Z| cos(phase) that leaves tan(phase) = -G'(0) / (w G(0)) and J = w |1/Z| / hypot(w G(0), G'(0)):
// one impulse, on the side where it is positive, whatever the load.
ImpactOrbit orbit_without_gap(const test::ImpactOscillator& o) {
  const double decay = 0.5 * o.damping / o.mass;
  const Complex mode(-decay, std::sqrt(o.stiffness / o.mass - decay * decay));
  const double period = 2.0 * std::numbers::pi / o.frequency;
  const Complex scale = 1.0 / (1.0 - std::exp(mode * period)) / (o.mass * mode.imag());
  const double response = scale.imag();
  const double rate = 0.5 * (mode * (1.0 + std::exp(mode * period)) * scale).imag();
  const Complex stiffness(o.stiffness - o.mass * o.frequency * o.frequency, o.damping * o.frequency);
  const double impulse =
      o.load * o.frequency / std::abs(stiffness) / std::hypot(o.frequency * response, rate);
  // cos(phase) has the sign of G(0).
  const double phase = std::atan2(-rate, o.frequency * response);
  const double time = (phase + std::arg(stiffness)) / o.frequency;
  return {time - period * std::floor(time / period), impulse};
}

TEST(SourceScene, IsTheOneMassOfSection3) {
  ASSERT_EQ(scene().size(), 1);
  ASSERT_EQ(scene().contact_count(), 1);
  EXPECT_EQ(scene().contacts[0].gap, 0.0);
  ASSERT_EQ(scene().force.size(), 1U);  // (20): f = cos wt
  EXPECT_EQ(scene().force[0].harmonic, 1);
  EXPECT_EQ(scene().force[0].cos, 1.0);
  EXPECT_EQ(scene().force[0].sin, 0.0);
  EXPECT_EQ(scene().subharmonic, 1);
  EXPECT_NE(scene().reference.find("[shi2015]"), std::string::npos);
}

TEST(SourceScene, HasOneOrbitOfOneImpactInClosedForm) {
  const ImpactOrbit exact = orbit_without_gap(oscillator());
  // By Runge-Kutta steps of a two-thousandth of a period with impacts located by Newton's method, 150 periods
  // from rest: the same digits but for those of rounding.
  EXPECT_NEAR(exact.time, 0.0247162691499, 1e-12);
  EXPECT_NEAR(exact.impulse, 2.0 * 2.0 * 0.34410707607758, 1e-12);
  const auto orbits = test::single_impact_orbits(oscillator());
  ASSERT_EQ(orbits.size(), 1U);
  EXPECT_NEAR(orbits[0].impact_time, exact.time, 1e-12);
  EXPECT_NEAR(orbits[0].impulse, exact.impulse, 1e-12);
  EXPECT_TRUE(orbits[0].stable());
}

TEST(SourceScene, GrowsWithItsLoad) {
  auto loaded = oscillator();
  loaded.load = 3.0;
  const ImpactOrbit exact = orbit_without_gap(oscillator());
  const auto orbits = test::single_impact_orbits(loaded);
  ASSERT_EQ(orbits.size(), 1U);
  EXPECT_NEAR(orbits[0].impact_time, exact.time, 1e-12);
  EXPECT_NEAR(orbits[0].impulse, 3.0 * exact.impulse, 1e-12);
}

TEST(SourceScene, IsSolvedByTheMethodsOfTheSourcePaper) {
  const auto orbit = test::single_impact_orbits(oscillator()).at(0);
  const auto error = [&](const Solution& solution) {
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    return test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); });
  };
  // Section 3.1, with the restitution that it lacks. Measured: 1.06e-2.
  EXPECT_LE(error(solve<HatLcp>(scene(), {.samples = 1024})), 1.2e-2);
  // Section 3.2. Measured: 4.3e-2; with impacts closed 1.3e-3.
  EXPECT_LE(error(solve<FourierLipschitz>(scene(), {.common = {.harmonics = 40}})), 5e-2);
  EXPECT_LE(error(solve<ClosedHbm>(scene(), {.harmonics = 40})), 1.6e-3);
  // Section 6. Measured: 4.5e-2.
  EXPECT_LE(error(solve<PenaltyHbm>(scene(), {.common = {.harmonics = 40}})), 5e-2);
}

}  // namespace
}  // namespace signorini::source_scene_test
