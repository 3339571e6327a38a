// Impacts of a given restitution, judged by closed-form orbits.

#include "methods/complementarity/impact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "methods/structure/receptance.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::impact_motion_test {
namespace {

using test::ImpactOscillator;
using test::SingleImpactOrbit;

/// One mass under a load of frequency 2.2, its stop at 0.2.
ImpactOscillator oscillator(double restitution) {
  return {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = restitution};
}

PeriodicImpacts impacts_of(const SingleImpactOrbit& orbit) {
  PeriodicImpacts impacts{{0}, Eigen::Matrix2Xd(2, 1)};
  impacts.moments << orbit.impact_time / orbit.period, orbit.impulse / orbit.period;
  return impacts;
}

/// A scene's motion behind impacts, the response given up to harmonic L.
struct Scene {
  explicit Scene(const Problem& problem, int harmonics, double restitution)
      : receptance(fourier_receptance(problem, harmonics)),
        gap(contact_gaps(problem)),
        motion(receptance, receptance.free_response, gap, restitution) {}

  ContactReceptance receptance;
  Eigen::VectorXd gap;
  ImpactMotion motion;
};

class RestitutionOfImpacts : public testing::TestWithParam<double> {};

TEST_P(RestitutionOfImpacts, IsThatOfTheClosedFormOrbit) {
  const ImpactOscillator scene = oscillator(GetParam());
  const auto orbits = test::single_impact_orbits(scene);
  ASSERT_FALSE(orbits.empty());
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int harmonics : {50, 100, 200, 400}) {
    const Scene series(test::to_problem(scene), harmonics, GetParam());
    const Eigen::VectorXd defect = series.motion.residual(impacts_of(orbits.front()));
    steps.push_back(1.0 / harmonics);
    errors.push_back(defect.lpNorm<Eigen::Infinity>());
  }
  EXPECT_LE(errors.back(), 1e-8);
  // What is neglected beyond L is of fourth order in 1/n, its sum of third.
  const double order = test::observed_order(steps, errors);
  EXPECT_GE(order, 2.7);
  EXPECT_LE(order, 3.3);
}

TEST_P(RestitutionOfImpacts, HoldsBetweenTheVelocitiesOfTheSettledMotion) {
  const ImpactOscillator scene = oscillator(GetParam());
  const SingleImpactOrbit orbit = test::single_impact_orbits(scene).front();
  const Scene series(test::to_problem(scene), 200, GetParam());
  PeriodicImpacts start = impacts_of(orbit);
  start.moments(0, 0) += 0.05;
  start.moments(1, 0) *= 0.9;
  const auto settled = series.motion.settle(start, 1e-13);
  ASSERT_TRUE(settled);
  EXPECT_LE(settled->steps, 7);
  EXPECT_NEAR(settled->impacts.moments(0, 0), orbit.impact_time / orbit.period, 1e-7);
  EXPECT_NEAR(settled->impacts.moments(1, 0), orbit.impulse / orbit.period, 1e-7);
  const auto [before, after] = series.motion.velocities(settled->impacts, 0);
  EXPECT_NEAR(before, orbit.approach * orbit.period, 1e-5 * before);
  EXPECT_NEAR(after, -GetParam() * before, 1e-11 * before);
  EXPECT_LE(series.motion.overshoot(settled->impacts), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OneMass, RestitutionOfImpacts, testing::Values(1.0, 0.9, 0.8, 0.5, 0.2, 0.0));

TEST(ImpactMotion, PassesItsStopWhereTheMassSticks) {
  // Under a preload of restitution 0 the mass would be pushed through the stop after the impact.
  const ImpactOscillator scene{.damping = 0.1, .frequency = 0.4, .gap = -0.3, .restitution = 0.0};
  const Scene series(test::to_problem(scene), 200, 0.0);
  bool found = false;
  for (int i = 0; i < 50 && !found; ++i) {
    PeriodicImpacts start{{0}, Eigen::Matrix2Xd(2, 1)};
    start.moments << i / 50.0, 0.1;
    const auto settled = series.motion.settle(start, 1e-12);
    if (!settled) continue;
    found = true;
    EXPECT_GE(series.motion.overshoot(settled->impacts), 1e-3 * series.motion.size(settled->impacts));
  }
  EXPECT_TRUE(found);
}

TEST(ImpactMotion, TellsTwoImpactsAtOneInstantOnContactsThatDependOnEachOther) {
  const Problem chain = test::damped_chain(4, 4);
  const Scene series(chain, 100, 0.5);
  PeriodicImpacts impacts{{0, 1}, Eigen::Matrix2Xd(2, 2)};
  impacts.moments << 0.3, 0.3, 1.0, 1.0;
  EXPECT_FALSE(series.motion.are_separate(impacts));  // x_0 - x_1 / 2 and x_1 - x_2 / 2 share a mass
  impacts.moments(0, 1) = 0.3 + 1e-6;
  EXPECT_TRUE(series.motion.are_separate(impacts));
  impacts.moments(0, 1) = 1.3;
  EXPECT_FALSE(series.motion.are_separate(impacts));
}

TEST(ImpactMotion, ImpulsesDoTheWorkThatTheLawTakes) {
  // The mean velocity at an impact times the impulse is what the mass loses, (1 - e^2) m v^2 / 2.
  constexpr double kRestitution = 0.5;
  const ImpactOscillator scene = oscillator(kRestitution);
  const SingleImpactOrbit orbit = test::single_impact_orbits(scene).front();
  const Scene series(test::to_problem(scene), 200, kRestitution);
  const auto settled = series.motion.settle(impacts_of(orbit), 1e-13);
  ASSERT_TRUE(settled);
  const auto [before, after] = series.motion.velocities(settled->impacts, 0);
  const double work = settled->impacts.moments(1, 0) * 0.5 * (before + after);
  const double speed = orbit.approach;
  EXPECT_NEAR(work, 0.5 * (1.0 - kRestitution * kRestitution) * speed * speed, 1e-5);
}

}  // namespace
}  // namespace signorini::impact_motion_test
