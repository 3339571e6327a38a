#include "methods/harmonic_balance/series_solution.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// One oscillator and its equations.
struct Scene {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  ContactReceptance receptance = fourier_receptance(problem, 4);
  Eigen::VectorXd gap = contact_gaps(problem);
  ProjectedLaw law{Eigen::VectorXd::Constant(1, 8.0), Eigen::VectorXd::Constant(1, 0.75)};

  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
};

TEST(SeriesData, IsTheResponseToLoadAndForce) {
  const Scene scene;
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(5, 1);
  lambda(0, 0) = -0.5;
  lambda(3, 0) = std::complex<double>(0.1, -0.2);
  const FourierTrajectory::Data data = series_data(scene.equations(), lambda);
  EXPECT_EQ(data.lambda, lambda);
  EXPECT_EQ(data.period, scene.receptance.period);
  EXPECT_EQ(data.stiffness[0], 8.0);
  EXPECT_EQ(data.multiplier_weight[0], 0.75);
  EXPECT_TRUE(data.shifts.empty());
  // Static stiffness 1: x_0 = lambda_0; harmonic 3 answers by 1 / (1 - 9 w^2 + 3 i d w).
  EXPECT_LE(std::abs(data.x(0, 0) + 0.5), 1e-15);
  const std::complex<double> stiffness(1.0 - 9.0 * 2.2 * 2.2, 3.0 * 0.1 * 2.2);
  EXPECT_LE(std::abs(data.x(3, 0) - lambda(3, 0) / stiffness), 1e-15);
}

TEST(ExactSolution, ClaimsTheProjectionAndSaysHowItWasFound) {
  const Scene scene;
  const ExactProjection solved{
      .converged = true, .residual = 1e-12, .condition = 30.0, .lambda = Eigen::MatrixXcd::Zero(5, 1)};
  const Solution solution = exact_solution(scene.equations(), solved, "by hand");
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.message, "by hand; contact integral exact, net contact work 0.0e+00 of that exchanged");
  EXPECT_EQ(solution.residual, 1e-12);
  EXPECT_EQ(solution.condition, 30.0);
  EXPECT_EQ(solution.trajectory->bandwidth(), 4);
}

TEST(ContactFreeResponse, HasAPeriodAndNoContact) {
  Scene scene;
  scene.problem.contacts.clear();
  const Solution solution = contact_free_response(fourier_receptance(scene.problem, 4));
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.trajectory->contact_count(), 0);
  EXPECT_DOUBLE_EQ(solution.trajectory->period(), scene.problem.period());
  EXPECT_EQ(solution.work.unknowns, 0);
}

}  // namespace
}  // namespace signorini
