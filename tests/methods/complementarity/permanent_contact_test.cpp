#include "methods/complementarity/permanent_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

// A mass pressed against its stop harder than the load can pull.
const test::ImpactOscillator kPressed{.damping = 0.1, .frequency = 0.6, .gap = -1.5, .restitution = 0.0};

ProjectedLaw rigid(double constant) {
  return {Eigen::VectorXd::Constant(1, constant), Eigen::VectorXd::Ones(1)};
}

ExactProjection solve_with_gap(double gap, const ProjectedLaw& law) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  const Eigen::VectorXd gaps = Eigen::VectorXd::Constant(1, gap);
  return solve_permanent_contact({receptance, gaps, law}, 1e-10);
}

TEST(PermanentContact, TakesTheStaticForceAndTheLoadWhateverTheConstant) {
  for (const double constant : {0.1, 1.0, 1e4}) {
    const ExactProjection closed = solve_with_gap(kPressed.gap, rigid(constant));
    ASSERT_TRUE(closed.converged);
    EXPECT_EQ(closed.iterations, 0);
    // lambda = k g - cos(omega t).
    EXPECT_NEAR(std::abs(closed.lambda(0, 0) + 1.5), 0.0, 1e-13);
    EXPECT_NEAR(std::abs(closed.lambda(1, 0) + 0.5), 0.0, 1e-13);
    EXPECT_LE(closed.lambda.bottomRows(2).norm(), 1e-12);
  }
}

TEST(PermanentContact, OfASpringStopIsTheMassOnTwoSprings) {
  // -lambda = k_p (x - g), (k + k_p) x_0 = k_p g, and in harmonic 1 x_1 = f_1 / (k + k_p - w^2 + i d w).
  constexpr double kStop = 300.0;
  const ProjectedLaw spring{Eigen::VectorXd::Constant(1, kStop), Eigen::VectorXd::Zero(1)};
  const ExactProjection closed = solve_with_gap(kPressed.gap, spring);
  ASSERT_TRUE(closed.converged);
  const double mean = kStop * kPressed.gap / (1.0 + kStop);
  EXPECT_NEAR(closed.lambda(0, 0).real(), -kStop * (mean - kPressed.gap), 1e-11);
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  const std::complex<double> stiffness = 1.0 / receptance.receptance[1](0, 0);
  const std::complex<double> x = receptance.free_response(1, 0) * stiffness / (stiffness + kStop);
  EXPECT_LE(std::abs(closed.lambda(1, 0) + kStop * x), 1e-11);
}

TEST(PermanentContact, IsRefusedWhereTheLoadPullsTheMassAway) {
  EXPECT_FALSE(solve_with_gap(-0.9, rigid(1.0)).converged);
  EXPECT_FALSE(solve_with_gap(0.5, rigid(1.0)).converged);
}

}  // namespace
}  // namespace signorini
