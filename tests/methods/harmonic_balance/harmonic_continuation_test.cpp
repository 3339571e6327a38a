#include "methods/harmonic_balance/harmonic_continuation.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::harmonic_continuation_test {
namespace {

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

ProjectedLaw rigid_at(const ContactReceptance& level) {
  return {4.0 * highest_dynamic_stiffness(level), Eigen::VectorXd::Ones(level.contacts())};
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

TEST(ContinuationStart, HasFewHarmonicsButTwiceThoseOfTheLoad) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_EQ(continuation_start(fourier_receptance(problem, 20)).harmonics, 0);
  const ContinuationPoint start = continuation_start(fourier_receptance(problem, 160));
  EXPECT_EQ(start.harmonics, 20);
  EXPECT_EQ(start.stiffness_factor, 1.0 / 16.0);
  Problem loaded = problem;
  loaded.force.push_back({.dof = 0, .harmonic = 15, .cos = 0.1});
  EXPECT_EQ(continuation_start(fourier_receptance(loaded, 160)).harmonics, 30);
}

TEST(ContinuationStart, HasFewerHarmonicsWhereThereAreManyContacts) {
  const auto with_contacts = [](int contacts) {
    ContactReceptance receptance;
    receptance.receptance.assign(161, Eigen::MatrixXcd::Identity(contacts, contacts));
    receptance.free_response = Eigen::MatrixXcd::Zero(161, contacts);
    return continuation_start(receptance).harmonics;
  };
  EXPECT_EQ(with_contacts(40), 20);
  EXPECT_EQ(with_contacts(80), 10);
  EXPECT_EQ(with_contacts(400), 5);
}

TEST(ContinueInHarmonics, ReachesWhatPivotingOnTheFineGridFinds) {
  const Problem problem = test::to_problem(kStop);
  const Solution continued = test::solve<FourierLipschitz>(problem, {{.harmonics = 60}});
  const Solution pivoted = test::solve<FourierLipschitz>(
      problem, {.common = {.harmonics = 60, .samples = 64 * 60}, .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(continued.verdict, Verdict::converged) << continued.message;
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  EXPECT_NE(continued.message.find("20 harmonics first"), std::string::npos) << continued.message;
  EXPECT_NE(pivoted.message.find("contact integral exact"), std::string::npos) << pivoted.message;
  EXPECT_LE(test::relative_distance(*continued.trajectory, *pivoted.trajectory), 1e-8);
  EXPECT_LE(continued.work.pivots.value(), 20);
  EXPECT_LE(continued.work.iterations.value(), 60);
}

TEST(ContinueInHarmonics, CallsNothingConvergedThatDoesNotSolveTheEquations) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kStop), 80);
  const Eigen::VectorXd gap = Eigen::VectorXd::Constant(1, kStop.gap);
  Eigen::MatrixXcd wild = Eigen::MatrixXcd::Constant(21, 1, std::complex<double>(1e3, -1e3));
  wild(0, 0) = 1e3;  // pulls
  const ExactProjection continued = continue_in_harmonics(
      receptance, gap, rigid_at, {.harmonics = 20, .stiffness_factor = 1.0 / 16.0}, wild, 1e-10, {});
  // It may end anywhere, but what it calls converged must solve the equations.
  if (continued.converged) {
    const ProjectedLaw law = rigid_at(receptance);
    const ExactProjection again =
        project_exactly({receptance, gap, law}, continued.lambda, {.samples = 16 * 80, .tolerance = 1e-9});
    EXPECT_EQ(again.iterations, 0);
    EXPECT_TRUE(again.converged);
  } else {
    EXPECT_EQ(continued.lambda.size(), 0);
  }
}

TEST(ContinueInHarmonics, EndsWithItsTimeBudget) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kStop), 80);
  const Start late{.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)};
  const ExactProjection continued = continue_in_harmonics(
      receptance, Eigen::VectorXd::Constant(1, kStop.gap), rigid_at,
      {.harmonics = 20, .stiffness_factor = 1.0 / 16.0}, Eigen::MatrixXcd::Zero(21, 1), 1e-10, late);
  EXPECT_FALSE(continued.converged);
  EXPECT_EQ(continued.iterations, 0);
}

}  // namespace
}  // namespace signorini::harmonic_continuation_test
