#include "methods/harmonic_balance/continuation/series_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "methods/discretisation/fourier_series.hpp"
#include "tests/methods/harmonic_balance/continuation/series_families.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::series_point_test {
namespace {

using Complex = std::complex<double>;

/// e^{s T} and its conjugate, s the eigenvalues of m s^2 + c s + k, m = 1.
void expect_multipliers_of_oscillator(const Eigen::VectorXcd& found, double damping, double stiffness,
                                      double period) {
  ASSERT_EQ(found.size(), 2);
  const Complex s(-0.5 * damping, std::sqrt(stiffness - 0.25 * damping * damping));
  const Complex expected = std::exp(s * period);
  for (const Complex& mu : found)
    EXPECT_LT(std::min(std::abs(mu - expected), std::abs(mu - std::conj(expected))), 1e-12);
}

TEST(ExtremesOf, AreExactBetweenSamples) {
  Eigen::VectorXcd y = Eigen::VectorXcd::Zero(4);
  y[0] = 0.3;
  y[1] = std::polar(0.5, 0.7);  // cos(2 pi t + .7)
  const auto [least, largest] = extremes_of(y);
  EXPECT_NEAR(least, -0.7, 1e-14);
  EXPECT_NEAR(largest, 1.3, 1e-14);
}

TEST(ExtremesOf, BoundTheSeriesAndAreReached) {
  Eigen::VectorXcd y(5);
  y << 0.1, Complex(0.4, -0.2), Complex(-0.3, 0.1), Complex(0.05, 0.2), Complex(0.1, 0.0);
  const auto [least, largest] = extremes_of(y);
  double low = 1e9, high = -1e9;
  for (int i = 0; i < 100000; ++i) {
    const double value = trigonometric_jet(y, i / 1e5).value;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_LE(least, low);
  EXPECT_GE(largest, high);
  EXPECT_NEAR(least, low, 1e-7);
  EXPECT_NEAR(largest, high, 1e-7);
}

TEST(BranchPointOfSeries, WithoutContactIsTheLinearResponse) {
  const Problem problem = test::to_problem({.damping = 0.1, .gap = 5.0});
  const SeriesFamily family = test::family_of(problem, 6);
  SeriesCurve curve(family, 1);
  ASSERT_TRUE(curve.evaluate(curve.unknowns(Eigen::MatrixXcd::Zero(7, 1), 2.0)));
  const SolutionPoint point = solution_point(curve);
  EXPECT_EQ(point.impacts, 0);
  EXPECT_EQ(point.order, 1);
  EXPECT_DOUBLE_EQ(point.parameter, 2.0);
  EXPECT_NEAR(point.amplitude[0], 1.0 / std::hypot(1.0 - 4.0, 0.1 * 2.0), 1e-14);
  EXPECT_EQ(point.stability, OrbitStability::stable);
  expect_multipliers_of_oscillator(point.multipliers, 0.1, 1.0, std::numbers::pi);
}

TEST(BranchPointOfSeries, OfASpringPressedThroughoutIsOfTheStifferOscillator) {
  // A preload of 9 on a stop at -0.5 with stiffness 5 never opens under a load of 1.
  Problem problem = test::to_problem({.damping = 0.1, .gap = -0.5, .static_load = 9.0});
  problem.set_law(Penalty{{5.0}});
  const SeriesFamily family = test::family_of(problem, 4);
  SeriesCurve curve(family, 1);
  // lambda = -5 (x + 1/2) with x under P0 and under cos(omega t).
  const double omega = 2.0, mean = (9.0 - 5.0 * 0.5) / 6.0;
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(5, 1);
  lambda(0, 0) = -5.0 * (mean + 0.5);
  lambda(1, 0) = -5.0 * 0.5 / Complex(6.0 - omega * omega, 0.1 * omega);
  ASSERT_TRUE(curve.evaluate(curve.unknowns(lambda, omega)));
  EXPECT_LT(curve.residual().norm(), 1e-12) << "the closed form solves the equations";
  const SolutionPoint point = solution_point(curve);
  EXPECT_EQ(point.impacts, 1) << "one phase of contact, without end";
  expect_multipliers_of_oscillator(point.multipliers, 0.1, 6.0, 2.0 * std::numbers::pi / omega);
}

TEST(BranchPointOfSeries, StabilityOfImpactsOnARigidStopIsNotKnown) {
  const Problem problem = test::to_problem({.damping = 0.1, .gap = 0.2});
  const SeriesFamily family = test::family_of(problem, 6);
  SeriesCurve curve(family, 1);
  ASSERT_TRUE(curve.evaluate(curve.unknowns(Eigen::MatrixXcd::Zero(7, 1), 1.6)));
  const SolutionPoint point = solution_point(curve);
  ASSERT_EQ(point.impacts, 1) << "the linear response goes through the stop";
  EXPECT_EQ(point.stability, OrbitStability::unknown);
  EXPECT_EQ(point.multipliers.size(), 0);
}

TEST(BranchPointOfSeries, WithoutDampingIsElliptic) {
  const Problem problem = test::to_problem({.damping = 0.0, .gap = 5.0});
  const SeriesFamily family = test::family_of(problem, 4);
  SeriesCurve curve(family, 1);
  ASSERT_TRUE(curve.evaluate(curve.unknowns(Eigen::MatrixXcd::Zero(5, 1), 2.1)));
  EXPECT_EQ(solution_point(curve).stability, OrbitStability::elliptic);
}

}  // namespace
}  // namespace signorini::series_point_test
