// Curves of special points in two parameters against closed forms of the impact oscillator.

#include "methods/orbit/bifurcation_curves/bifurcation_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::bifurcation_curve_test {
namespace {

Problem oscillator(double gap, double restitution) {
  return to_problem(test::ImpactOscillator{.damping = 0.1, .gap = gap, .restitution = restitution});
}

ScenePlane over_restitution(double from, double to) {
  return {.at = [](double e) { return over_frequency(oscillator(0.2, e), 1.5, 4.5); },
          .second = "law.restitution",
          .from = from,
          .to = to};
}

ScenePlane over_gap(double from, double to) {
  return {.at = [](double gap) { return over_frequency(oscillator(gap, 0.8), 1.5, 4.5); },
          .second = "contact[0].gap",
          .from = from,
          .to = to};
}

std::vector<Branch> curves_of(const ScenePlane& plane, SpecialKind kind) {
  OrbitFamily family(plane.at(plane.from));
  const OrbitDiagram diagram =
      trace_diagram(family, {contact_free_orbit(family, family.scene().to).value()}, {});
  return bifurcation_curves(plane, diagram, kind, {});
}

// The nearest frequency at which a curve that began near `from` reaches the end of the second interval.
double at_the_end(const std::vector<Branch>& curves, double from, double expected) {
  double best = 1e300;
  for (const Branch& curve : curves) {
    if (std::abs(curve.points.front().frequency - from) > 1e-6) continue;
    EXPECT_NE(curve.ended.find("end of the interval"), std::string::npos) << curve.ended;
    if (std::abs(curve.points.back().frequency - expected) < std::abs(best - expected))
      best = curve.points.back().frequency;
  }
  return best;
}

// Located at e = 1, 0.8 and 0.5 in the closed form of one impact in n periods, by a scan and bisection.
TEST(BifurcationCurves, JoinTheFoldsOfTheOscillatorOverItsRestitution) {
  EXPECT_NEAR(
      at_the_end(curves_of(over_restitution(1.0, 0.8), SpecialKind::fold), 3.8553753210396, 3.6934249832280),
      3.6934249832280, 1e-9);
  EXPECT_NEAR(
      at_the_end(curves_of(over_restitution(1.0, 0.5), SpecialKind::fold), 3.8553753210396, 3.4543608376498),
      3.4543608376498, 1e-9);
}

TEST(BifurcationCurves, JoinTheDoublingsOfTheOscillatorOverItsRestitution) {
  const auto curves = curves_of(over_restitution(1.0, 0.5), SpecialKind::period_doubling);
  EXPECT_NEAR(at_the_end(curves, 2.2647019400124, 2.2646455610069), 2.2646455610069, 1e-9);
  EXPECT_NEAR(at_the_end(curves, 2.9125835786788, 2.8104370993468), 2.8104370993468, 1e-9);
  for (const Branch& curve : curves) {
    for (const SolutionPoint& point : curve.points)
      EXPECT_LT((point.multipliers.array() + 1.0).abs().minCoeff(), 1e-4);
  }
}

// The motion without contact grazes where its amplitude |1 / (1 - w^2 + i c w)| is the gap.
TEST(BifurcationCurves, OfGrazingsAreTheLinearResponse) {
  const auto curves = curves_of(over_gap(0.2, 0.7), SpecialKind::grazing);
  ASSERT_FALSE(curves.empty());
  bool free = false;
  for (const Branch& curve : curves) {
    if (curve.sequence != "order 1, no events") continue;
    free = true;
    ASSERT_GT(curve.points.size(), 3U);
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const double w = curve.points[i].frequency;
      const double amplitude = std::abs(1.0 / std::complex<double>(1.0 - w * w, 0.1 * w));
      EXPECT_NEAR(amplitude, *curve.points[i].second, 1e-11) << w;
    }
    EXPECT_NEAR(*curve.points.back().second, 0.7, 1e-12);
    EXPECT_EQ(curve.ended, "end of the interval of contact[0].gap");
  }
  EXPECT_TRUE(free);
}

// All of them are neighbours, and what one curve joins is not followed twice.
TEST(BifurcationCurves, AreFollowedInSmallStepsAndOnce) {
  const auto curves = curves_of(over_gap(0.2, 0.3), SpecialKind::fold);
  for (std::size_t a = 0; a < curves.size(); ++a) {
    for (std::size_t i = 1; i < curves[a].points.size(); ++i) {
      EXPECT_LT(std::abs(curves[a].points[i].frequency - curves[a].points[i - 1].frequency), 0.2);
      EXPECT_LT(std::abs(*curves[a].points[i].second - *curves[a].points[i - 1].second), 0.01);
    }
    for (std::size_t b = 0; b < a; ++b) {
      const SolutionPoint &p = curves[a].points.front(), &q = curves[b].points.front();
      EXPECT_GT(std::abs(p.frequency - q.frequency) + std::abs(p.x_max[0] - q.x_max[0]) +
                    std::abs(p.amplitude[0] - q.amplitude[0]),
                1e-6);
    }
  }
  EXPECT_FALSE(has_curve(SpecialKind::branch_point));
  EXPECT_THROW((void)bifurcation_curves(over_gap(0.2, 0.3), {}, SpecialKind::branch_point, {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace signorini::bifurcation_curve_test
