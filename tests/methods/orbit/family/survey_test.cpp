// Guards and extremes of closed-form orbits against dense samples of the closed form.

#include "methods/orbit/family/survey.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>

#include "methods/orbit/arc_scan.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/closed_form_guess.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::survey_test {
namespace {

SequencedOrbit placed(OrbitFamily& family, const test::SingleImpactOrbit& orbit) {
  return sequenced(family, test::closed_form_guess(orbit, 0.4), orbit.period, orbit.oscillator.frequency,
                   orbit.oscillator.frequency);
}

TEST(Survey, HasTheGuardsAndExtremesOfTheClosedForm) {
  for (const double frequency : {1.2, 1.7, 2.2, 2.8}) {
    for (const int order : {1, 2}) {
      const test::ImpactOscillator oscillator{
          .damping = 0.1, .frequency = frequency, .gap = 0.2, .restitution = 0.8, .order = order};
      OrbitFamily family(over_frequency(test::to_problem(oscillator), 1.0, 3.0));
      for (const test::SingleImpactOrbit& orbit : test::single_impact_orbits(oscillator)) {
        const SequencedOrbit at = placed(family, orbit);
        ExtendedEquations equations(family, at);
        ASSERT_TRUE(equations.evaluate(at.x));
        const OrbitSurvey found = survey(equations);
        EXPECT_NEAR(found.find(GuardKind::approach, 0)->value * family.units().velocity, orbit.approach,
                    1e-11);
        EXPECT_NEAR(found.highest[0], 0.2, 1e-12);
        double lowest = 1.0, peak = -1e300;
        constexpr int kSamples = 20000;
        double before = orbit.x(orbit.impact_time + 1e-9), rising = 0.0;
        for (int i = 1; i < kSamples; ++i) {
          const double x = orbit.x(orbit.impact_time + i * orbit.period / kSamples);
          lowest = std::min(lowest, x);
          if (rising > 0.0 && x < before) peak = std::max(peak, before);
          rising = x - before;
          before = x;
        }
        EXPECT_NEAR(found.lowest[0], lowest, 1e-6 * std::abs(lowest));
        const OrbitGuard* clearance = found.find(GuardKind::clearance, 0);
        ASSERT_EQ(clearance != nullptr, peak > -1e300) << frequency << " " << order;
        if (clearance != nullptr) {
          EXPECT_NEAR(clearance->value * family.units().displacement, 0.2 - peak, 1e-5);
        }
      }
    }
  }
}

// Rank 5 to rounding, with multipliers that are known: M = S D S^-1.
TEST(Multipliers, OfALargeMatrixOfSmallRankAreThoseOfItsRange) {
  constexpr Eigen::Index kSize = 40;
  std::srand(7);
  const Eigen::MatrixXd S =
      Eigen::MatrixXd::Random(kSize, kSize) + 3.0 * Eigen::MatrixXd::Identity(kSize, kSize);
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(kSize, kSize);
  D.topLeftCorner(2, 2) << 0.3, -0.9, 0.9, 0.3;
  D(2, 2) = -1.7;
  D(3, 3) = 0.5;
  D(4, 4) = 1e-3;
  const Eigen::VectorXcd found = multipliers_of(S * D * S.inverse());
  ASSERT_EQ(found.size(), kSize);
  for (const std::complex<double> mu :
       {std::complex<double>(0.3, 0.9), std::complex<double>(0.3, -0.9), std::complex<double>(-1.7),
        std::complex<double>(0.5), std::complex<double>(1e-3)})
    EXPECT_LT((found.array() - mu).abs().minCoeff(), 1e-11) << mu;
  EXPECT_EQ((found.array().abs() > 1e-11).count(), 5);
}

// Every sample of a motion lies within its extremes, and the extremes are samples of it.
TEST(Extremes, BoundDenseSamplesOfABeamThatRings) {
  const Problem problem = load_scene(find_scene("beam10-tip-stop"));
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  for (const bool closed : {false, true}) {
    const auto arc = flows.of({closed}).arc();
    const Eigen::Index n = dynamics.size();
    arc->start(0.0, {.u = Eigen::VectorXd::Zero(n), .v = Eigen::VectorXd::LinSpaced(n, -1.0, 1.0)});
    const double end = problem.forcing_period();
    const LimitedOutput x{.arc = *arc, .contact = 0, .of_force = false, .offset = 0.0, .unit = 1.0};
    double highest = -1e300, lowest = 1e300;
    for (const LimitedSample& at : extremes(x, 0.0, end, arc->fading_rates(1e-13))) {
      highest = std::max(highest, at.value);
      lowest = std::min(lowest, at.value);
      EXPECT_EQ(at.value, arc->displacement(0, at.time));
    }
    constexpr int kSamples = 200000;
    double top = -1e300, bottom = 1e300;
    for (int i = 0; i <= kSamples; ++i) {
      const double sample = arc->displacement(0, end * i / kSamples);
      top = std::max(top, sample);
      bottom = std::min(bottom, sample);
    }
    EXPECT_LE(top, highest + 1e-15 * std::abs(highest));
    EXPECT_GE(bottom, lowest - 1e-15 * std::abs(lowest));
    EXPECT_NEAR(top, highest, 1e-4 * (highest - lowest));
    EXPECT_NEAR(bottom, lowest, 1e-4 * (highest - lowest));
    // The same two among samples of several outputs together.
    LimitedOutput turned = x;
    turned.unit = -1.0;
    const std::vector<LimitedSample> peaks =
        largest(std::vector{x, turned}, 0.0, end, arc->fading_rates(1e-13));
    EXPECT_NEAR(peaks[0].value, highest, 1e-12 * (highest - lowest));
    EXPECT_NEAR(peaks[1].value, -lowest, 1e-12 * (highest - lowest));
    EXPECT_NEAR(peaks[0].value, arc->displacement(0, peaks[0].time), 1e-12 * (highest - lowest));
  }
}

TEST(BifurcationTests, HaveTheMultipliersOfTheClosedForm) {
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.6, .gap = 0.2, .order = 2};
  OrbitFamily family(over_frequency(test::to_problem(oscillator), 1.0, 3.0));
  for (const test::SingleImpactOrbit& orbit : test::single_impact_orbits(oscillator)) {
    const SequencedOrbit at = placed(family, orbit);
    ExtendedEquations equations(family, at);
    ASSERT_TRUE(equations.evaluate(at.x));
    const BifurcationTests tests =
        bifurcation_tests(equations, Eigen::VectorXd::Unit(at.x.size(), at.x.size() - 1));
    EXPECT_NEAR(tests.multipliers.sum().real(), orbit.trace, 1e-10);
    EXPECT_NEAR(tests.multipliers.prod().real(), orbit.determinant, 1e-10);
    EXPECT_EQ(stability_of(equations, tests.multipliers) == OrbitStability::stable, orbit.stable());
    EXPECT_FALSE(tests.of(SpecialKind::neimark_sacker));
    EXPECT_FALSE(loses_nothing(equations));
    // The sign of det(M + 1) v: a doubling changes it, a grazing does not.
    const double doubled = (1.0 + orbit.trace + orbit.determinant) * orbit.approach;
    EXPECT_EQ(*tests.of(SpecialKind::period_doubling) > 0.0, doubled > 0.0);
  }
}

TEST(Confirmed, AsksForTheMultipliersOfTheBifurcation) {
  Eigen::VectorXcd mu(2);
  mu << -1.0, 0.3;
  EXPECT_TRUE(confirmed(SpecialKind::period_doubling, mu));
  EXPECT_FALSE(confirmed(SpecialKind::neimark_sacker, mu));
  mu << std::polar(1.0, 0.7), std::polar(1.0, -0.7);
  EXPECT_TRUE(confirmed(SpecialKind::neimark_sacker, mu));
  EXPECT_FALSE(confirmed(SpecialKind::period_doubling, mu));
  mu << 2.0, 0.5;  // a product of 1, no pair on the circle
  EXPECT_FALSE(confirmed(SpecialKind::neimark_sacker, mu));
}

}  // namespace
}  // namespace signorini::survey_test
