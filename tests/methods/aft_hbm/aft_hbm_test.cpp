#include "methods/aft_hbm/aft_hbm.hpp"

#include <gtest/gtest.h>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

using test::relative_distance;
using test::solve;

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

class AftEqualsItsTwin : public testing::TestWithParam<int> {};

TEST_P(AftEqualsItsTwin, DynamicLagrangiansAreFourierLipschitz) {
  const int harmonics = GetParam();
  const int samples = 32 * harmonics;
  const Problem problem = test::to_problem(kStop);
  const Solution aft = solve<AftHbm>(
      problem, {.harmonics = harmonics, .samples = samples, .c = 10.0, .quadrature = Quadrature::sampled});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  const Solution twin = solve<FourierLipschitz>(
      problem, {.harmonics = harmonics, .samples = samples, .c = 10.0, .quadrature = Quadrature::sampled});
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

TEST_P(AftEqualsItsTwin, ThePenaltyLawIsPenaltyHbm) {
  const int harmonics = GetParam();
  const int samples = 32 * harmonics;
  const Problem problem = test::to_problem(kStop);
  const Scaled penalty{300.0, false};
  const Solution aft = solve<AftHbm>(problem, {.harmonics = harmonics,
                                               .samples = samples,
                                               .law = AftHbm::ContactLaw::penalty,
                                               .penalty = penalty,
                                               .quadrature = Quadrature::sampled});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  const Solution twin = solve<PenaltyHbm>(
      problem,
      {.harmonics = harmonics, .samples = samples, .penalty = penalty, .quadrature = Quadrature::sampled});
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

TEST_P(AftEqualsItsTwin, AlsoWithTheExactContactIntegral) {
  const Problem problem = test::to_problem(kStop);
  const Solution aft = solve<AftHbm>(problem, {.harmonics = GetParam()});
  const Solution twin = solve<FourierLipschitz>(problem, {.harmonics = GetParam()});
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  EXPECT_LE(relative_distance(*twin.trajectory, *aft.trajectory), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Harmonics, AftEqualsItsTwin, testing::Values(3, 10, 25));

class AftResidualTest : public testing::Test {
 protected:
  AftResidualTest() {
    problem_ = test::to_problem(kStop);
    problem_.contacts.push_back({{{0, -1.0}}, 0.4});
    const ContactReceptance receptance = fourier_receptance(problem_, 6);
    residual_ = std::make_unique<AftResidual>(receptance, contact_gaps(problem_),
                                              lipschitz_law(problem_, 10.0, receptance), 64);
    std::srand(7);
    lambda_ = Eigen::VectorXd::Random(residual_->unknowns());
  }

  Problem problem_;
  std::unique_ptr<AftResidual> residual_;
  Eigen::VectorXd lambda_;
};

TEST_F(AftResidualTest, JacobianVectorProductMatchesFiniteDifferences) {
  std::vector<char> contact;
  const Eigen::VectorXd r = residual_->residual(lambda_, contact);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd v = Eigen::VectorXd::Random(residual_->unknowns());
    constexpr double kStep = 1e-7;  // piecewise linear: exact unless a sample switches on the way
    std::vector<char> unused;
    const Eigen::VectorXd difference = (residual_->residual(lambda_ + kStep * v, unused) - r) / kStep;
    EXPECT_LE((residual_->product(contact, v) - difference).norm(), 1e-6 * difference.norm());
  }
}

TEST_F(AftResidualTest, ProjectionIsIdempotentAndSelfAdjoint) {
  const Eigen::VectorXd signal = Eigen::VectorXd::Random(128);
  const Eigen::VectorXd other = Eigen::VectorXd::Random(128);
  const Eigen::VectorXd coefficients = residual_->project(signal);
  // |P s|_2 in coefficients is the root mean square of the projected signal.
  EXPECT_LE(coefficients.norm(), std::sqrt(signal.squaredNorm() / 64));
  const auto round_trip = residual_->unknowns_of(residual_->coefficients(coefficients));
  EXPECT_LE((round_trip - coefficients).norm(), 1e-14 * coefficients.norm());
}

TEST_F(AftResidualTest, PreconditionerInvertsTheJacobianOfUniformContact) {
  // One contact closed throughout, the other (the opposite stop of the same mass) open.
  for (const char state : {char{0}, char{1}}) {
    std::vector<char> contact(128, 0);
    std::fill_n(contact.begin(), 64, state);
    const Eigen::VectorXd back = residual_->lasting_inverse(contact) * residual_->product(contact, lambda_);
    EXPECT_LE((back - lambda_).norm(), 1e-10 * lambda_.norm());
  }
}

TEST(AftHbm, NewtonAloneIsWhatTheHomotopyRepairs) {
  const Problem problem = test::to_problem(kStop);
  const Solution alone = solve<AftHbm>(problem, {.harmonics = 20, .samples = 640, .homotopy = false});
  EXPECT_EQ(alone.verdict, Verdict::not_converged);
  EXPECT_GT(alone.residual.value(), 1e-10);
  const Solution repaired = solve<AftHbm>(problem, {.harmonics = 20, .samples = 640});
  EXPECT_EQ(repaired.verdict, Verdict::converged) << repaired.message;
}

TEST(AftHbm, NeedsAtMostTwoStepsFromTheAnswer) {
  const Problem problem = test::to_problem(kStop);
  const Solution cold =
      solve<AftHbm>(problem, {.harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled});
  const AftHbm::Options newton{
      .harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled, .homotopy = false};
  const Solution warm = solve<AftHbm>(problem, newton, cold.trajectory);
  ASSERT_EQ(warm.verdict, Verdict::converged) << warm.message;
  EXPECT_LE(warm.work.iterations.value(), 2);
}

TEST(AftHbm, StopsAtItsIterationLimit) {
  const Solution solution =
      solve<AftHbm>(test::to_problem(kStop), {.harmonics = 10, .samples = 320, .max_iterations = 5});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_LE(solution.work.iterations.value() + solution.work.pivots.value_or(0), 5);
}

TEST(AftHbm, RefusesOptionsThatContradictItsLaw) {
  EXPECT_THROW(AftHbm({.penalty = Scaled{1.0, true}}), InvalidOption);
  EXPECT_THROW(AftHbm({.law = AftHbm::ContactLaw::penalty, .c = 1.0}), InvalidOption);
  EXPECT_THROW(AftHbm({.harmonics = 10, .samples = 15}), InvalidOption);
}

TEST(AftHbm, TakesNoStepWhereNothingTouches) {
  const Solution solution = solve<AftHbm>(test::to_problem({.frequency = 2.2, .gap = 3.0}), {.harmonics = 3});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.work.iterations.value(), 0);
  EXPECT_FALSE(solution.work.pivots.has_value());
  EXPECT_EQ(solution.trajectory->force_coefficients().norm(), 0.0);
}

TEST(AftHbm, SeparatesTheTiesOfTwoSymmetricStops) {
  Problem problem = test::to_problem({.damping = 0.05, .frequency = 1.2, .gap = 0.3, .restitution = 1.0});
  Contact other = problem.contacts.front();
  for (auto& [dof, coefficient] : other.normal) coefficient = -coefficient;
  problem.contacts.push_back(other);
  const Solution solution = solve<AftHbm>(problem, {.harmonics = 12});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Solution twin = solve<FourierLipschitz>(problem, {.harmonics = 12});
  ASSERT_EQ(twin.verdict, Verdict::converged) << twin.message;
  EXPECT_LE(relative_distance(*twin.trajectory, *solution.trajectory), 1e-7);
}

TEST(AftHbm, ReportsARayAndLeavesFiniteNumbers) {
  // Light damping and few samples break the energy balance that excludes rays.
  const Problem problem =
      test::to_problem({.damping = 0.003, .frequency = 1.6, .gap = 0.5, .restitution = 1.0});
  int rays = 0;
  for (const int samples : {24, 32, 48, 64, 96, 128}) {
    const Solution solution =
        solve<AftHbm>(problem, {.harmonics = 10, .samples = samples, .quadrature = Quadrature::sampled});
    rays += solution.message.find("ray") != std::string::npos ? 1 : 0;
    ASSERT_NE(solution.trajectory, nullptr) << samples;
    EXPECT_TRUE(solution.trajectory->sample(16).x.allFinite()) << samples;
  }
  EXPECT_GE(rays, 1);
}

}  // namespace
}  // namespace signorini
