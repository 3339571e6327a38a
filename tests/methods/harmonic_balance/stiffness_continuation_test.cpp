#include "methods/harmonic_balance/stiffness_continuation.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::stiffness_continuation_test {
namespace {

constexpr int kHarmonics = 40;

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

struct Scene {
  ContactReceptance receptance = fourier_receptance(test::to_problem(kStop), kHarmonics);
  Eigen::VectorXd gap = Eigen::VectorXd::Constant(1, kStop.gap);
  ProjectedLaw law{4.0 * highest_dynamic_stiffness(receptance), Eigen::VectorXd::Ones(1)};
  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
  [[nodiscard]] static ExactProjectionSettings settings() { return {.samples = 16 * kHarmonics}; }
};

// One Newton run does not get from no force at all to the stop; from springs on it does, and to the series
// that pivoting finds.
TEST(ContinueInStiffness, FindsFromNoForceWhatPivotingFinds) {
  const Scene scene;
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(kHarmonics + 1, 1);
  EXPECT_FALSE(project_exactly(scene.equations(), none, Scene::settings()).converged);
  const ExactProjection found = continue_in_stiffness(scene.equations(), none, Scene::settings());
  ASSERT_TRUE(found.converged);
  EXPECT_LE(found.residual, 1e-10);
  EXPECT_LE(found.iterations, 150);
  const Solution pivoted = test::solve<FourierLipschitz>(
      test::to_problem(kStop), {.common = {.harmonics = kHarmonics, .samples = 64 * kHarmonics},
                                .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  const Eigen::MatrixXcd& force = pivoted.trajectory->force_coefficients();
  EXPECT_LE((found.lambda - force).norm(), 1e-7 * force.norm());
}

// A force that is no number starts nothing; what failed has no residual that could pass for a small one.
TEST(ContinueInStiffness, ClaimsNothingWhereNoSpringIsSoftEnough) {
  const Scene scene;
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Constant(kHarmonics + 1, 1, std::nan(""));
  const ExactProjection found = continue_in_stiffness(scene.equations(), none, Scene::settings());
  EXPECT_FALSE(found.converged);
  EXPECT_TRUE(std::isinf(found.residual));
  EXPECT_EQ(found.lambda.size(), 0);
}

TEST(ContinueInStiffness, EndsWithItsTimeBudget) {
  const Scene scene;
  ExactProjectionSettings late = Scene::settings();
  late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  const ExactProjection found =
      continue_in_stiffness(scene.equations(), Eigen::MatrixXcd::Zero(kHarmonics + 1, 1), late);
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.iterations, 0);
  EXPECT_EQ(found.lambda.size(), 0);
}

}  // namespace
}  // namespace signorini::stiffness_continuation_test
