// Coordinates behind a motion at the contacts, against the one-mass impact oscillator in closed form.

#include "harness/summary/coordinate_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "methods/hat_lcp/hat_lcp.hpp"
#include "problems/moving_frame.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::coordinate_motion_test {
namespace {

constexpr int kCoordinateInstants = 1000;

/// The orbit as impulses alone tell it: its displacement is left out, and has to be found.
test::FormulaMotion impulses_of_orbit(const test::SingleImpactOrbit& orbit) {
  const auto nothing = [](double) { return 0.0; };
  return {orbit.period,
          nothing,
          nothing,
          nothing,
          {{.contact = 0, .time = orbit.impact_time, .value = -orbit.impulse}}};
}

CoordinateMotion first_coordinate(const Problem& problem, const Trajectory& motion) {
  return {problem, motion, sample_motion(problem, motion), std::array{0}};
}

// Told at rest, a motion that meets no stop knows nothing of how its stop moves.
TEST(CoordinateMotion, OfASceneWithAMovingStopIsToldAtRest) {
  const Problem resting = test::to_problem({.damping = 0.3, .frequency = 2.2, .gap = 50.0});
  Problem moving = resting;
  move_stops(moving, {{.contact = 0, .cos = 0.3, .sin = -0.2}, {.contact = 0, .harmonic = 5, .sin = 0.1}});
  const auto nothing = [](double) { return 0.0; };
  const test::FormulaMotion open(resting.period(), nothing, nothing, nothing, {});
  const auto told = [&](const Problem& problem) { return first_coordinate(problem, open); };
  const CoordinateMotion expected = told(resting), found = told(moving);
  EXPECT_LT((found.displacement(kCoordinateInstants) - expected.displacement(kCoordinateInstants)).norm(),
            1e-11);
  EXPECT_LT((found.velocity(kCoordinateInstants) - expected.velocity(kCoordinateInstants)).norm(), 1e-10);
}

// The mean of a part that no spring holds follows from its contacts. Samples alone tell the motion here.
TEST(CoordinateMotion, OfALoosePartHasTheMeanOfItsContact) {
  const Problem gear = test::gear_backlash();
  const auto answer = test::solve<HatLcp>(gear, {.samples = 512}).trajectory;
  const Eigen::VectorXd u = first_coordinate(gear, *answer).displacement(kCoordinateInstants).col(0);
  EXPECT_NEAR(u.minCoeff(), 0.8392488693, 1e-5);
  EXPECT_NEAR(u.maxCoeff(), 1.2975814541, 1e-5);
}

TEST(CoordinateMotion, OfTheImpactOscillatorIsTheClosedFormThroughTheImpact) {
  for (const int order : {1, 2}) {
    const test::ImpactOscillator oscillator{.damping = 0.3,
                                            .frequency = order == 1 ? 2.2 : 2.8,
                                            .gap = order == 1 ? 0.05 : 0.2,

                                            .restitution = 0.8,
                                            .order = order,
                                            .static_load = 0.1};
    const auto orbits = test::single_impact_orbits(oscillator);
    ASSERT_FALSE(orbits.empty()) << order;
    const Problem problem = test::to_problem(oscillator);
    const CoordinateMotion field = first_coordinate(problem, impulses_of_orbit(orbits.front()));
    const Eigen::MatrixXd u = field.displacement(kCoordinateInstants),
                          v = field.velocity(kCoordinateInstants);
    double apart = 0.0, speeds_apart = 0.0;
    for (int i = 0; i < kCoordinateInstants; ++i) {
      const double t = i * orbits.front().period / kCoordinateInstants;
      apart = std::max(apart, std::abs(u(i, 0) - orbits.front().x(t)));
      speeds_apart = std::max(speeds_apart, std::abs(v(i, 0) - orbits.front().velocity(t)));
    }
    EXPECT_LT(apart, 1e-9) << order;
    EXPECT_LT(apart, field.error().value()) << order;
    EXPECT_LT(speeds_apart, 1e-6) << order;
  }
}

TEST(CoordinateMotion, WithABandwidthIsTheSeriesOfThatMany) {
  // The response of one coordinate to a cosine is one harmonic, whatever the grid.
  const Problem problem = test::one_mass();
  const auto nothing = [](double) { return 0.0; };
  const test::FormulaMotion motion(problem.period(), nothing, nothing, nothing, {}, 1);
  const std::complex<double> response = 1.0 / std::complex<double>(1.0 - 4.0, 0.2);
  const Eigen::MatrixXd u = first_coordinate(problem, motion).displacement(5);
  for (int i = 0; i < 5; ++i) {
    const double expected = (response * std::polar(1.0, 2.0 * i * problem.period() / 5.0)).real();
    EXPECT_NEAR(u(i, 0), expected, 1e-14);
  }
}

}  // namespace
}  // namespace signorini::coordinate_motion_test
