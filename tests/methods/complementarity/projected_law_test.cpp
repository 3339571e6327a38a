#include "methods/complementarity/projected_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

TEST(HighestDynamicStiffness, OfOneMassIsItsInertiaAtThreeQuartersOfTheHighestHarmonics) {
  const Problem problem = test::to_problem({.mass = 2.0, .frequency = 3.0, .gap = 0.1});
  const double scale = highest_dynamic_stiffness(fourier_receptance(problem, 40))[0];
  // Mean of 1/(m n^2 w^2) over n from 20 to 40 is close to 1/(m w^2 20 40).
  EXPECT_NEAR(scale / (2.0 * 9.0 * 20 * 40), 1.0, 0.05);
}

TEST(LipschitzLaw, OfASpringStopWeighsTheMultiplierByItsCompliance) {
  Problem problem = test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1});
  problem.law = Penalty{{100.0}};
  const ProjectedLaw law = lipschitz_law(problem, 10.0, fourier_receptance(problem, 3));
  EXPECT_DOUBLE_EQ(law.constant[0], 40.0);
  EXPECT_DOUBLE_EQ(law.multiplier_weight[0], 1.0 - 40.0 / 100.0);
}

TEST(PenaltyLaw, IsTheScenesSpringOrTheStiffnessAskedFor) {
  Problem problem = test::to_problem({.stiffness = 4.0, .frequency = 3.0, .gap = 0.1});
  const ContactReceptance receptance = fourier_receptance(problem, 3);
  EXPECT_DOUBLE_EQ(penalty_law(problem, Scaled{10.0, true}, receptance).constant[0], 40.0);
  EXPECT_DOUBLE_EQ(penalty_law(problem, Scaled{10.0, false}, receptance).constant[0], 10.0);
  EXPECT_DOUBLE_EQ(penalty_law(problem, {}, receptance).constant[0],
                   8.0 * highest_dynamic_stiffness(receptance)[0]);
  problem.law = Penalty{{100.0}};
  const ProjectedLaw law = penalty_law(problem, {}, receptance);
  EXPECT_DOUBLE_EQ(law.constant[0], 100.0);
  EXPECT_DOUBLE_EQ(law.multiplier_weight[0], 0.0);
}

TEST(StiffnessFactor, KeepsTheLawOfASpringStop) {
  // c = k_p, alpha = 0 is the spring; with any other constant lambda = -k_p (x - g) in contact still:
  // -lambda = c (x - g) - alpha lambda gives (1 - alpha) lambda = -c (x - g).
  const ProjectedLaw spring{Eigen::VectorXd::Constant(1, 300.0), Eigen::VectorXd::Zero(1)};
  const ProjectedLaw soft = with_stiffness_factor(spring, 0.25);
  EXPECT_DOUBLE_EQ(soft.constant[0], 75.0);
  EXPECT_DOUBLE_EQ(soft.constant[0] / (1.0 - soft.multiplier_weight[0]), 300.0);
  const ProjectedLaw rigid{Eigen::VectorXd::Constant(1, 8.0), Eigen::VectorXd::Ones(1)};
  EXPECT_DOUBLE_EQ(with_stiffness_factor(rigid, 0.5).multiplier_weight[0], 1.0);
}

TEST(ProjectedMethodLaw, IsConservativeWhereTheStopIsRigid) {
  Problem problem = test::to_problem({.frequency = 3.0, .gap = 0.1, .restitution = 0.3});
  EXPECT_EQ(std::get<Restitution>(projected_method_law(problem)).e, 1.0);
  problem.law = Penalty{{100.0}};
  EXPECT_EQ(std::get<Penalty>(projected_method_law(problem)).stiffness.front(), 100.0);
  EXPECT_EQ(std::get<Penalty>(projected_method_law(problem, Scaled{7.0, false})).stiffness.front(), 7.0);
}

}  // namespace
}  // namespace signorini
