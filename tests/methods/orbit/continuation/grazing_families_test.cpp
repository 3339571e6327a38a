// The patterns that begin at a grazing against the fixed-point index of the return map, and against closed
// forms.

#include "methods/orbit/continuation/grazing_families.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "methods/orbit/family/extended_equations.hpp"
#include "methods/orbit/family/survey.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

// h^T M^k (1 + M^n + M^2n + ...) b, summed.
Eigen::VectorXd summed_response(const Eigen::Matrix2d& M, const Eigen::Vector2d& b, const Eigen::Vector2d& h,
                                int n) {
  Eigen::VectorXd response = Eigen::VectorXd::Zero(n);
  Eigen::Vector2d y = b;
  for (int k = 0; k < 600 * n; ++k, y = (M * y).eval()) response[k % n] += h.dot(y);
  return response;
}

// Sum of sign det C_SS over all n-periodic patterns of one side, their rotations and repetitions included.
int index_sum(const Eigen::Matrix2d& M, const Eigen::Vector2d& b, const Eigen::Vector2d& h, int n,
              bool beyond) {
  const Eigen::VectorXd response = summed_response(M, b, h, n);
  Eigen::MatrixXd C(n, n);
  for (int a = 0; a < n; ++a) {
    for (int l = 0; l < n; ++l) C(a, l) = response[(a - l + n) % n];
  }
  int sum = beyond ? 0 : 1;  // the orbit without impact clears its stop
  for (int m = 1; m <= n; ++m) {
    if (n % m != 0) continue;
    for (const GrazingFamily& family : impact_patterns(summed_response(M, b, h, m))) {
      if (family.beyond != beyond) continue;
      std::vector<int> hits;
      for (int k = 0; k < n; k += m) {
        for (const int hit : family.hits) hits.push_back(hit + k);
      }
      sum += m * (C(hits, hits).determinant() > 0.0 ? 1 : -1);
    }
  }
  return sum;
}

TEST(ImpactPatterns, KeepTheIndexOfTheReturnMapAcrossAGrazing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int cases = 0, families = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double angle = 3.0 * number(random), decay = 0.55 + 0.4 * number(random);
    Eigen::Matrix2d M;
    M << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    M *= decay;
    const Eigen::Vector2d b(0.0, 1.0), h(1.0, number(random));
    for (int n = 1; n <= 6; ++n, ++cases) {
      EXPECT_EQ(index_sum(M, b, h, n, true), index_sum(M, b, h, n, false)) << trial << " n = " << n;
      families += static_cast<int>(impact_patterns(summed_response(M, b, h, n)).size());
    }
  }
  EXPECT_EQ(cases, 360);
  EXPECT_GT(families, 360);
}

// One impact in one period where the stop would be passed, one in two where it is cleared, and no other.
TEST(GrazingFamilies, OfTheImpactOscillatorAreThoseOfItsClosedForm) {
  constexpr double kGrazing = 2.448265181813;
  const test::ImpactOscillator oscillator{.damping = 0.1, .gap = 0.2, .restitution = 0.8};
  OrbitFamily family(over_frequency(test::to_problem(oscillator), 2.0, 3.0));
  const SequencedOrbit base = contact_free_orbit(family, kGrazing).value();
  ExtendedEquations equations(family, base);
  ASSERT_TRUE(equations.evaluate(base.x));
  const double phase = survey(equations).find(GuardKind::clearance, 0)->phase;
  const auto families = grazing_families(family, base, 0, phase, 6);
  ASSERT_TRUE(families);
  ASSERT_EQ(families->size(), 2U);
  EXPECT_EQ((*families)[0].periods, 1);
  EXPECT_TRUE((*families)[0].beyond);
  EXPECT_EQ((*families)[1].periods, 2);
  EXPECT_FALSE((*families)[1].beyond);
  EXPECT_EQ((*families)[1].hits, std::vector<int>{0});
  // J of a small penetration by the closed form: the impulses of (1, 1) and (1, 2) beside the grazing.
  for (const GrazingFamily& found : *families) {
    test::ImpactOscillator beside = oscillator;
    beside.order = found.periods;
    beside.frequency = kGrazing + (found.beyond ? -1e-7 : 1e-7);
    const double amplitude =
        1.0 / std::hypot(1.0 - beside.frequency * beside.frequency, 0.1 * beside.frequency);
    double ratio = 1e300;  // of the weaker of the two orbits
    for (const test::SingleImpactOrbit& orbit : test::single_impact_orbits(beside))
      ratio = std::min(ratio, orbit.impulse / std::abs(amplitude - beside.gap));
    EXPECT_NEAR(ratio / found.impulses[0], 1.0, 1e-4) << found.periods;
  }
}

// At w = 2 wd n / j a unit impulse every n periods is back where it acted: the first order says nothing.
TEST(GrazingFamilies, AreUndecidedWhereTheResponseVanishes) {
  const double wd = std::sqrt(1.0 - 0.05 * 0.05);
  const test::ImpactOscillator oscillator{.damping = 0.1, .gap = 0.2};
  OrbitFamily family(over_frequency(test::to_problem(oscillator), 1.0, 3.0));
  const SequencedOrbit base = contact_free_orbit(family, 2.0 * wd).value();
  EXPECT_FALSE(grazing_families(family, base, 0, 1.0, 1));
}

}  // namespace
}  // namespace signorini
