#include "methods/discretisation/symbols.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/accuracy.hpp"

namespace signorini::symbols_test {
namespace {

using Complex = std::complex<double>;

constexpr double kStep = 0.3;
constexpr std::array kAngles{0.0, 1e-4, 0.3, 1.0, 2.5, std::numbers::pi};

void expect_near(Complex a, Complex b, double tolerance) { EXPECT_LE(std::abs(a - b), tolerance); }

/// Value and slope of the hat function of node j at t, nodes kStep apart.
double hat(int j, double t) { return std::max(0.0, 1.0 - std::abs(t / kStep - j)); }
double slope(int j, double t) { return (t < j * kStep ? 1.0 : -1.0) / kStep; }

/// The integral of f over the support of node 0, exact for cubics on each element (Simpson's rule, its ends
/// just inside the element, where slopes are defined).
template <class Function>
double integral(const Function& f) {
  double sum = 0.0;
  for (const double left : {-kStep, 0.0}) {
    const double inside = 1e-12 * kStep;
    sum += kStep / 6.0 * (f(left + inside) + 4.0 * f(left + 0.5 * kStep) + f(left + kStep - inside));
  }
  return sum;
}

// M x'' + D x' + K x tested with the hat of node 0, x = sum_j e^{i j theta} hat_j, over the step: the
// definition.
TEST(SchemeWeights, OfGalerkinAreTheIntegralsOfHatFunctions) {
  for (const double theta : kAngles) {
    Complex mass = 0.0, damping = 0.0, stiffness = 0.0;
    for (int j = -1; j <= 1; ++j) {
      const Complex phase = std::polar(1.0, j * theta);
      // Outside its two elements a hat has no slope.
      const auto bent = [j](double t) { return hat(j, t) > 0.0 ? slope(j, t) : 0.0; };
      mass -= phase * integral([&](double t) { return bent(t) * slope(0, t); }) / kStep;
      damping += phase * integral([&](double t) { return hat(0, t) * bent(t); }) / kStep;
      stiffness += phase * integral([&](double t) { return hat(0, t) * hat(j, t); }) / kStep;
    }
    const HarmonicWeights weights = scheme_weights(HatScheme::galerkin, theta, kStep);
    expect_near(weights.mass, mass, 1e-9);
    expect_near(weights.damping, damping, 1e-9);
    expect_near(weights.stiffness, stiffness, 1e-9);
    EXPECT_NEAR(weights.load, stiffness.real(), 1e-9);
  }
}

TEST(SchemeWeights, OfNodalAndBackwardAreTheirDifferenceQuotients) {
  for (const double theta : kAngles) {
    const auto x = [theta](int k) { return std::polar(1.0, k * theta); };
    const HarmonicWeights nodal = scheme_weights(HatScheme::nodal, theta, kStep);
    expect_near(nodal.mass, (x(1) - 2.0 * x(0) + x(-1)) / (kStep * kStep), 1e-14 / (kStep * kStep));
    expect_near(nodal.damping, (x(1) - x(-1)) / (2.0 * kStep), 1e-14);
    expect_near(nodal.stiffness, 1.0, 0.0);
    const HarmonicWeights backward = scheme_weights(HatScheme::backward, theta, kStep);
    expect_near(backward.mass, (x(0) - 2.0 * x(-1) + x(-2)) / (kStep * kStep), 1e-14 / (kStep * kStep));
    expect_near(backward.damping, (x(0) - x(-1)) / kStep, 1e-14);
    expect_near(backward.stiffness, 1.0, 0.0);
    const HarmonicWeights second = scheme_weights(HatScheme::bdf2, theta, kStep);
    const auto slope = [&](int k) { return (3.0 * x(k) - 4.0 * x(k - 1) + x(k - 2)) / (2.0 * kStep); };
    expect_near(second.damping, slope(0), 1e-13);
    expect_near(second.mass, (3.0 * slope(0) - 4.0 * slope(-1) + slope(-2)) / (2.0 * kStep), 1e-12);
    expect_near(second.stiffness, 1.0, 0.0);
    EXPECT_EQ(second.load, 1.0);
    EXPECT_EQ(nodal.load, 1.0);
    EXPECT_EQ(backward.load, 1.0);
  }
}

TEST(ContactForceWeight, IsTheGramMatrixOfHatFunctionsWhereTheyInterpolateTheForce) {
  for (const double theta : kAngles) {
    const HarmonicWeights consistent = scheme_weights(HatScheme::consistent, theta, kStep);
    EXPECT_EQ(contact_force_weight(HatScheme::galerkin, theta), 1.0);
    EXPECT_NEAR(contact_force_weight(HatScheme::consistent, theta), consistent.load, 1e-15);
    EXPECT_EQ(consistent.mass, scheme_weights(HatScheme::galerkin, theta, kStep).mass);
  }
}

TEST(SchemeWeights, ApproachTheExactOnesWithTheirOrder) {
  constexpr double kFrequency = 2.0;
  for (const HatScheme scheme :
       {HatScheme::galerkin, HatScheme::nodal, HatScheme::backward, HatScheme::bdf2}) {
    std::vector<double> steps;
    std::vector<double> errors;
    for (double step = 0.1; step > 0.005; step /= 2.0) {
      const HarmonicWeights weights = scheme_weights(scheme, kFrequency * step, step);
      const HarmonicWeights exact = exact_weights(kFrequency);
      steps.push_back(step);
      // Galerkin weights load and stiffness alike: relative to the weight of the load.
      errors.push_back(std::abs(weights.mass / weights.load - exact.mass) +
                       std::abs(weights.damping / weights.load - exact.damping));
    }
    const double order = test::observed_order(steps, errors);
    EXPECT_NEAR(order, scheme == HatScheme::backward ? 1.0 : 2.0, 0.05);
  }
}

TEST(SchemeWeights, KeepTheInertiaOfTheLowestHarmonicOfAFineGrid) {
  constexpr double kTheta = 1e-7;  // 1 - cos theta keeps two digits here
  const double exact = -kTheta * kTheta / (kStep * kStep);
  EXPECT_NEAR(scheme_weights(HatScheme::nodal, kTheta, kStep).mass.real() / exact, 1.0, 1e-12);
}

TEST(ExactWeights, AreThoseOfDerivativesOfAHarmonic) {
  const HarmonicWeights weights = exact_weights(3.0);
  EXPECT_EQ(weights.mass, Complex(-9.0, 0.0));
  EXPECT_EQ(weights.damping, Complex(0.0, 3.0));
  EXPECT_EQ(weights.stiffness, Complex(1.0, 0.0));
  EXPECT_EQ(weights.load, 1.0);
}

TEST(RestitutionShift, IsTheMeanOfTheNeighboursWeightedByRestitution) {
  for (const double theta : kAngles) {
    expect_near(restitution_shift(std::nullopt, theta), 1.0, 0.0);
    expect_near(restitution_shift(0.0, theta), std::polar(1.0, theta), 1e-15);
    expect_near(restitution_shift(1.0, theta), std::cos(theta), 1e-15);
    const Complex x = std::polar(1.0, 0.7);
    const Complex ahead = x * std::polar(1.0, theta);
    const Complex behind = x * std::polar(1.0, -theta);
    expect_near(x * restitution_shift(0.25, theta), (4.0 * ahead + behind) / 5.0, 1e-15);
  }
}

}  // namespace
}  // namespace signorini::symbols_test
