#include "methods/complementarity/contact_episodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// A solution of the exactly projected equations and what its episodes need.
struct SolvedOscillator {
  explicit SolvedOscillator(const test::ImpactOscillator& oscillator, int harmonics)
      : problem(test::to_problem(oscillator)),
        receptance(fourier_receptance(problem, harmonics)),
        gap(contact_gaps(problem)),
        law(lipschitz_law(problem, {}, receptance)),
        response(fourier_receptance(problem, 2 * harmonics)) {
    const Solution solution =
        test::solve<FourierLipschitz>(problem, {{.harmonics = harmonics, .compensate = false}});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    lambda = solution.trajectory->force_coefficients();
  }

  [[nodiscard]] ContactEpisodes episodes() const {
    return contact_episodes({receptance, gap, law}, response, lambda, {}, 16 * receptance.harmonics());
  }

  Problem problem;
  ContactReceptance receptance;
  Eigen::VectorXd gap;
  ProjectedLaw law;
  PeriodicGreenFunction response;
  Eigen::MatrixXcd lambda;
};

TEST(ContactEpisodes, FindTheOneImpactAndAllOfItsForce) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 2.2, .gap = 0.2}, 20);
  const ContactEpisodes found = solved.episodes();
  ASSERT_EQ(found.impacts.size(), 1U);
  EXPECT_TRUE(found.lasting.empty());
  EXPECT_EQ(found.lasting_force.norm(), 0.0);
  const ContactEpisode& impact = found.impacts.front();
  // The episode's part is the whole force, and its mean the zeroth coefficient of the pressure.
  EXPECT_LE((impact.lambda - solved.lambda.col(0)).norm(), 1e-8 * solved.lambda.norm());
  EXPECT_NEAR(impact.force, -solved.lambda(0, 0).real(), 1e-8 * impact.force);
  EXPECT_LE(impact.width(), 2.5 / 20);
  EXPECT_GT(impact.load.value, 0.0);
  // Root mean square of x over the period, from samples.
  const Eigen::MatrixXcd x = contact_motion(solved.receptance, solved.lambda);
  const double expected = std::sqrt(std::norm(x(0, 0)) + 2.0 * x.col(0).tail(x.rows() - 1).squaredNorm());
  EXPECT_DOUBLE_EQ(found.motion, expected);
}

TEST(ContactEpisodes, CallContactThatLastsNoImpact) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 0.6, .gap = -1.5}, 20);
  const ContactEpisodes found = solved.episodes();
  EXPECT_TRUE(found.impacts.empty());
  ASSERT_EQ(found.lasting.size(), 1U);
  EXPECT_LE((found.lasting_force - solved.lambda).norm(), 1e-9 * solved.lambda.norm());
  EXPECT_FALSE(found.lasting_is_shifted);
}

TEST(AugmentedMultiplier, IsThePressureInContactAndNegativeOffIt) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 0.6, .gap = -1.5}, 20);
  const ProjectedEquations equations{solved.receptance, solved.gap, solved.law};
  const Eigen::MatrixXcd x = contact_motion(solved.receptance, solved.lambda);
  const Eigen::VectorXcd y = augmented_multiplier(equations, 0, x, solved.lambda);
  // Closed throughout: x = g and y = -lambda.
  EXPECT_LE((y + solved.lambda.col(0)).norm(), 1e-8 * solved.lambda.norm());
}

}  // namespace
}  // namespace signorini
