#include "methods/harmonic_balance/continuation/depth_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "methods/continuation/arc_length.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "tests/methods/harmonic_balance/continuation/series_families.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::depth_curve_test {
namespace {

// m = k = F = 1, c = .1, gap .2: the contact-free motion grazes at this frequency, closed form.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};
constexpr double kGrazing = 2.448265181813;
constexpr int kHarmonics = 20;

SeriesFamily stop_family() { return test::family_of(test::to_problem(kStop), kHarmonics); }

/// Unknowns of the contact-free motion.
Eigen::VectorXd free_at(const SeriesFamily& family, double frequency) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(2 * kHarmonics + 2);
  x[x.size() - 1] = frequency / family.frequency_unit;
  return x;
}

/// Unit vector along which the frequency falls.
Eigen::VectorXd downwards() { return -Eigen::VectorXd::Unit(2 * kHarmonics + 2, 2 * kHarmonics + 1); }

TEST(DepthCurve, DepthIsHalfTheLengthOfAShortContact) {
  const SeriesFamily family = stop_family();
  DepthCurve curve(family, 1);
  for (const double below : {1e-3, 1e-4, 1e-5}) {
    ASSERT_TRUE(curve.series().evaluate(free_at(family, kGrazing - below)));
    const std::vector<ContactDepth> depths = short_contacts(curve.series());
    ASSERT_EQ(depths.size(), 1U);
    curve.follow(depths);
    const ContactInterval interval = curve.series().contacts()[0].at(0);
    const double half = std::numbers::pi * kHarmonics * (interval.end - interval.begin);
    EXPECT_NEAR(curve.depths_here()[0], half, 2.0 * below * half);
    EXPECT_NEAR(depths[0].time, 0.5 * (interval.begin + interval.end), 1e-9);
  }
}

TEST(DepthCurve, JacobianIsThatOfDifferences) {
  const SeriesFamily family = stop_family();
  DepthCurve curve(family, 1);
  Eigen::VectorXd x = free_at(family, kGrazing - 1e-3);
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) x[i] = 1e-7 * std::sin(static_cast<double>(i));
  ASSERT_TRUE(curve.series().evaluate(x));
  curve.follow(short_contacts(curve.series()));
  ASSERT_EQ(curve.count(), 1);
  const Eigen::VectorXd z = curve.with_depths(x, Eigen::VectorXd::Constant(1, 0.3));
  ASSERT_TRUE(curve.evaluate(z));
  EXPECT_EQ(curve.z(), z);
  EXPECT_EQ(curve.without_depths(z), x);
  const Eigen::MatrixXd jacobian = curve.jacobian();
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    constexpr double kStep = 1e-7;
    const auto at = [&](double step) {
      EXPECT_TRUE(curve.evaluate(z + step * Eigen::VectorXd::Unit(z.size(), i)));
      return curve.residual();
    };
    const Eigen::VectorXd slope = (at(kStep) - at(-kStep)) / (2.0 * kStep);
    EXPECT_LT((slope - jacobian.col(i)).norm(), 1e-5 * slope.norm()) << i;
  }
}

TEST(DepthCurve, ContactsThatBeginAreForeseen) {
  const SeriesFamily family = stop_family();
  SeriesCurve curve(family, 1);
  constexpr double kAbove = 1e-4;
  ASSERT_TRUE(curve.evaluate(free_at(family, kGrazing + kAbove)));
  const auto found = nascent_contacts(curve, downwards(), 1e-3);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].distance * family.frequency_unit, kAbove, 1e-3 * kAbove);
  EXPECT_FALSE(found[0].depth.gap);
  EXPECT_TRUE(nascent_contacts(curve, downwards(), 1e-6).empty()) << "out of reach";
  EXPECT_TRUE(nascent_contacts(curve, -downwards(), 1e-3).empty()) << "the stop recedes";
}

// Within 1e-4 of the grazing the curve of x turns by more than a step may, .35 rad; that of (x, w) by less on
// each of ten steps over the same stretch, and Newton's method needs a few iterations.
TEST(DepthCurve, IsSmoothWhereAContactBegins) {
  const SeriesFamily family = stop_family();
  DepthCurve curve(family, 1);
  ASSERT_TRUE(curve.series().evaluate(free_at(family, kGrazing)));
  const auto nascent = nascent_contacts(curve.series(), downwards(), 1e-9);
  ASSERT_EQ(nascent.size(), 1U);
  curve.follow({nascent[0].depth});
  const Eigen::Index depth = curve.series().size();
  Eigen::VectorXd z = curve.with_depths(free_at(family, kGrazing), Eigen::VectorXd::Zero(1));
  Eigen::VectorXd tangent = Eigen::VectorXd::Unit(z.size(), depth);
  for (int i = 1; i <= 10; ++i) {
    const auto iterations = correct(curve, z + 0.01 * tangent, tangent);
    ASSERT_TRUE(iterations) << i;
    EXPECT_LE(*iterations, 6);
    z = curve.z();
    const auto next = tangent_of(curve, tangent);
    ASSERT_TRUE(next);
    EXPECT_GT(next->dot(tangent), std::cos(0.35)) << i;
    tangent = *next;
  }
  EXPECT_GT(z[depth], 0.05);
  const Eigen::VectorXd x = curve.without_depths(z), slope = curve.without_depths(tangent).normalized();
  EXPECT_LT((x - free_at(family, kGrazing)).norm(), 1e-4);
  EXPECT_LT(slope.dot(downwards()), std::cos(0.35));
}

}  // namespace
}  // namespace signorini::depth_curve_test
