// The patterns that begin at a grazing against the fixed-point index of the return map, and against closed
// forms.

#include "methods/orbit/starts/grazing_families.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "methods/orbit/family/extended_equations.hpp"
#include "methods/orbit/family/survey.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::grazing_families_test {
namespace {

// h^T M^k (1 + M^n + M^2n + ...) b, summed.
Eigen::VectorXd summed_response(const Eigen::Matrix2d& M, const Eigen::Vector2d& b, const Eigen::Vector2d& h,
                                int n) {
  Eigen::VectorXd response = Eigen::VectorXd::Zero(n);
  Eigen::Vector2d y = b;
  for (int k = 0; k < 600 * n; ++k, y = (M * y).eval()) response[k % n] += h.dot(y);
  return response;
}

Eigen::MatrixXd circulant(const Eigen::VectorXd& response) {
  const Eigen::Index n = response.size();
  Eigen::MatrixXd C(n, n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index l = 0; l < n; ++l) C(a, l) = response[(a - l + n) % n];
  }
  return C;
}

std::vector<GrazingFamily> patterns(const Eigen::VectorXd& response) {
  return impact_patterns(circulant(response), Eigen::VectorXd::Ones(1));
}

// Sum of sign det C_SS over all n-periodic patterns of one side, their rotations and repetitions included.
int index_sum(const Eigen::Matrix2d& M, const Eigen::Vector2d& b, const Eigen::Vector2d& h, int n,
              bool beyond) {
  const Eigen::MatrixXd C = circulant(summed_response(M, b, h, n));
  int sum = beyond ? 0 : 1;  // the orbit without impact clears its stop
  for (int m = 1; m <= n; ++m) {
    if (n % m != 0) continue;
    for (const GrazingFamily& family : patterns(summed_response(M, b, h, m))) {
      if (family.beyond != beyond) continue;
      std::vector<int> hits;
      for (int k = 0; k < n; k += m) {
        for (const int hit : family.hits) hits.push_back(hit + k);
      }
      sum += m * (determinant(C(hits, hits)) > 0.0 ? 1 : -1);
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
      families += static_cast<int>(patterns(summed_response(M, b, h, n)).size());
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
  const auto families = grazing_families(family, base, {{.contact = 0, .phase = phase}}, 6);
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

// Two touches in a period, marched through: displacement at each passage of n periods when a unit impulse
// acts at one of them, in every n-th period, since long ago.
Eigen::MatrixXd marched_response(const std::array<Eigen::Matrix2d, 2>& flow, const Eigen::Vector2d& b,
                                 const std::array<Eigen::Vector2d, 2>& h, int n) {
  Eigen::MatrixXd C(2 * n, 2 * n);
  for (int struck = 0; struck < 2 * n; ++struck) {
    Eigen::Vector2d y = Eigen::Vector2d::Zero();
    for (int passage = 0; passage < 800 * n; ++passage) {
      const auto touch = static_cast<std::size_t>(passage % 2);
      C(passage % (2 * n), struck) = h[touch].dot(y);
      if (passage % (2 * n) == struck) y += b;
      y = flow[touch] * y;
    }
  }
  return C;
}

TEST(ImpactPatterns, OfTwoTouchesKeepTheIndexToo) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int families = 0;
  for (int trial = 0; trial < 80; ++trial) {
    std::array<Eigen::Matrix2d, 2> flow;
    for (Eigen::Matrix2d& part : flow) {
      const double angle = 3.0 * number(random);
      part << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
      part *= 0.7 + 0.2 * number(random);
    }
    // Contacts on one coordinate: an impulse moves no displacement at once.
    const Eigen::Vector2d b(0.0, 1.0);
    const std::array<Eigen::Vector2d, 2> h{Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(1.0, 0.0)};
    const Eigen::Vector2d rates(1.0, trial % 4 == 0 ? 1.0 : 2.0 * number(random));
    const Eigen::MatrixXd C = marched_response(flow, b, h, 1);
    const std::vector<GrazingFamily> found = impact_patterns(C, rates);
    families += static_cast<int>(found.size());
    std::array<int, 2> sums{0, rates[1] > 0.0 ? 1 : 0};  // beyond; where both touches clear their stops
    for (const GrazingFamily& family : found)
      sums[family.beyond ? 0 : 1] += determinant(C(family.hits, family.hits)) > 0.0 ? 1 : -1;
    EXPECT_EQ(sums[0], sums[1]) << trial;
  }
  EXPECT_GT(families, 80);
}

// Between two stops at equal distance: responses by marching the free oscillator from touch to touch.
TEST(GrazingResponse, OfTwoTouchesIsThatOfAMarch) {
  constexpr double kFrequency = 1.9, kDamping = 0.1;
  Problem problem = test::to_problem({.damping = kDamping, .frequency = kFrequency, .gap = 0.2});
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.2, .law = problem.contacts.front().law});
  OrbitFamily family(over_frequency(problem, 1.5, 3.0));
  const SequencedOrbit base = contact_free_orbit(family, kFrequency).value();
  const Eigen::MatrixXd C =
      grazing_response(family, base, {{.contact = 0, .phase = 1.0}, {.contact = 1, .phase = 4.5}}, 2);
  ASSERT_EQ(C.rows(), 4);
  const double wd = std::sqrt(1.0 - 0.25 * kDamping * kDamping);
  // x after a unit impulse, a time s ago, summed over repetitions every 2 periods.
  const auto after = [&](double s) {
    double sum = 0.0;
    for (int k = 0; k < 200; ++k, s += 4.0 * std::numbers::pi / kFrequency)
      sum += std::exp(-0.5 * kDamping * s) * std::sin(wd * s) / wd;
    return sum;
  };
  const double phases[] = {1.0, 4.5}, sign[] = {1.0, -1.0};
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      const int periods = a / 2 - b / 2;
      double ago = phases[a % 2] - phases[b % 2] + 2.0 * std::numbers::pi * periods;
      if (ago < 0.0) ago += 4.0 * std::numbers::pi;
      EXPECT_NEAR(C(a, b), sign[a % 2] * sign[b % 2] * after(ago / kFrequency), 1e-9) << a << " " << b;
    }
  }
}

// At w = 2 wd n / j a unit impulse every n periods is back where it acted: the first order says nothing.
TEST(GrazingFamilies, AreUndecidedWhereTheResponseVanishes) {
  const double wd = std::sqrt(1.0 - 0.05 * 0.05);
  const test::ImpactOscillator oscillator{.damping = 0.1, .gap = 0.2};
  OrbitFamily family(over_frequency(test::to_problem(oscillator), 1.0, 3.0));
  const SequencedOrbit base = contact_free_orbit(family, 2.0 * wd).value();
  EXPECT_FALSE(grazing_families(family, base, {{.contact = 0, .phase = 1.0}}, 1));
}

}  // namespace
}  // namespace signorini::grazing_families_test
