#include "methods/harmonic_balance/harmonic_climb.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "methods/discretisation/trajectories.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};
// The same mass pressed against its stop harder than the load can pull.
const test::ImpactOscillator kPressed{.damping = 0.1, .frequency = 0.6, .gap = -1.5, .restitution = 0.0};

ProjectedLaw rigid(double constant) {
  return {Eigen::VectorXd::Constant(1, constant), Eigen::VectorXd::Ones(1)};
}

TEST(Truncated, KeepsTheFirstHarmonics) {
  const ContactReceptance all = fourier_receptance(test::to_problem(kStop), 12);
  const ContactReceptance some = truncated(all, 5);
  EXPECT_EQ(some.harmonics(), 5);
  EXPECT_EQ(some.period, all.period);
  EXPECT_EQ(some.receptance.back(), all.receptance[5]);
  EXPECT_EQ(some.free_response, all.free_response.topRows(6));
  EXPECT_EQ(truncated(all, 40).harmonics(), 12);
}

TEST(Softened, KeepsTheLawOfASpringStop) {
  // c = k_p, relief = 0 is the spring; with any other constant lambda = -k_p (x - g) in contact still:
  // -lambda = c (x - g) - relief lambda gives (1 - relief) lambda = -c (x - g).
  const ProjectedLaw spring{Eigen::VectorXd::Constant(1, 300.0), Eigen::VectorXd::Zero(1)};
  const ProjectedLaw soft = softened(spring, 0.25);
  EXPECT_DOUBLE_EQ(soft.constant[0], 75.0);
  EXPECT_DOUBLE_EQ(soft.constant[0] / (1.0 - soft.relief[0]), 300.0);
  EXPECT_DOUBLE_EQ(softened(rigid(8.0), 0.5).relief[0], 1.0);
}

TEST(PermanentContact, TakesTheStaticForceAndTheLoadWhateverTheConstant) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  for (const double constant : {0.1, 1.0, 1e4}) {
    const ExactProjection closed =
        permanent_contact(receptance, Eigen::VectorXd::Constant(1, kPressed.gap), rigid(constant), 1e-10);
    ASSERT_TRUE(closed.converged);
    EXPECT_EQ(closed.iterations, 0);
    // lambda = k g - cos(omega t).
    EXPECT_NEAR(std::abs(closed.lambda(0, 0) + 1.5), 0.0, 1e-13);
    EXPECT_NEAR(std::abs(closed.lambda(1, 0) + 0.5), 0.0, 1e-13);
    EXPECT_LE(closed.lambda.bottomRows(2).norm(), 1e-12);
  }
}

TEST(PermanentContact, IsRefusedWhereTheLoadPullsTheMassAway) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  EXPECT_FALSE(
      permanent_contact(receptance, Eigen::VectorXd::Constant(1, -0.9), rigid(1.0), 1e-10).converged);
  EXPECT_FALSE(permanent_contact(receptance, Eigen::VectorXd::Constant(1, 0.5), rigid(1.0), 1e-10).converged);
}

TEST(ClimbFoot, IsLowButHoldsTheLoadTwice) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_EQ(climb_foot(fourier_receptance(problem, 20)).harmonics, 0);
  EXPECT_EQ(climb_foot(fourier_receptance(problem, 160)).harmonics, 20);
  Problem loaded = problem;
  loaded.force.push_back({.dof = 0, .harmonic = 15, .cos = 0.1});
  EXPECT_EQ(climb_foot(fourier_receptance(loaded, 160)).harmonics, 30);
}

TEST(ClimbHarmonics, ReachesWhatPivotingOnTheFineGridFinds) {
  const Problem problem = test::to_problem(kStop);
  const Solution climbed = test::solve<FourierLipschitz>(problem, {.harmonics = 60});
  const Solution pivoted = test::solve<FourierLipschitz>(
      problem, {.harmonics = 60, .samples = 64 * 60, .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(climbed.verdict, Verdict::converged) << climbed.message;
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  EXPECT_NE(climbed.message.find("20 harmonics first"), std::string::npos) << climbed.message;
  EXPECT_NE(pivoted.message.find("contact integral exact"), std::string::npos) << pivoted.message;
  EXPECT_LE(test::relative_distance(*climbed.trajectory, *pivoted.trajectory), 1e-8);
  EXPECT_LE(climbed.work.pivots.value(), 20);
  EXPECT_LE(climbed.work.iterations.value(), 60);
}

TEST(ClimbHarmonics, CallsNothingConvergedThatDoesNotSolveTheEquations) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kStop), 80);
  const LawAt law = [](const ContactReceptance& level) {
    return rigid(4.0 * highest_dynamic_stiffness(level)[0]);
  };
  Eigen::MatrixXcd wild = Eigen::MatrixXcd::Constant(21, 1, std::complex<double>(1e3, -1e3));
  wild(0, 0) = 1e3;  // pulls
  const HarmonicClimb climb = climb_harmonics(receptance, Eigen::VectorXd::Constant(1, kStop.gap), law,
                                              {.harmonics = 20, .softness = 1.0 / 16.0}, wild, 1e-10, {});
  // It may end anywhere, but what it calls converged must solve the equations.
  if (climb.top.converged) {
    const ExactProjection again = project_exactly(receptance, Eigen::VectorXd::Constant(1, kStop.gap),
                                                  law(receptance), climb.top.lambda, 16 * 80, 1e-9);
    EXPECT_EQ(again.iterations, 0);
    EXPECT_TRUE(again.converged);
  } else {
    EXPECT_EQ(climb.top.lambda.size(), 0);
  }
}

TEST(WarmStart, IsTakenUpByNewtonAtOnce) {
  const Problem problem = test::to_problem(kStop);
  const Solution cold = test::solve<FourierLipschitz>(problem, {.harmonics = 40});
  const Solution warm = test::solve<FourierLipschitz>(problem, {.harmonics = 40}, cold.trajectory);
  ASSERT_EQ(warm.verdict, Verdict::converged) << warm.message;
  EXPECT_FALSE(warm.work.pivots.has_value());
  EXPECT_LE(warm.work.iterations.value(), 1);
  EXPECT_LE(test::relative_distance(*cold.trajectory, *warm.trajectory), 1e-12);
}

}  // namespace
}  // namespace signorini
