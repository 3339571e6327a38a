#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"

#include <gtest/gtest.h>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::augmented_lagrangian_test {
namespace {

using test::solve;

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

TEST(AugmentedLagrangian, SolvesTheLipschitzFormWithItsPenaltyAsConstant) {
  for (const double penalty : {100.0, 1e3, 1e4}) {
    const Problem problem = test::to_problem(kStop);
    const Solution solution = solve<AugmentedLagrangian>(
        problem, {.harmonics = 10, .penalty = Scaled{penalty, true}, .tolerance = 1e-12});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const auto lipschitz = FourierLipschitz({.common = {.harmonics = 10}, .c = penalty}).prepare(problem);
    const Solution same = lipschitz->solve({.guess = solution.trajectory});
    ASSERT_EQ(same.verdict, Verdict::converged) << same.message;
    EXPECT_LE(test::relative_distance(*solution.trajectory, *same.trajectory), 1e-10) << penalty;
  }
}

// Permanent contact: a penalty leaves a penetration that falls with its size, the multiplier takes it back.
TEST(AugmentedLagrangian, IsRidOfThePenaltysPenetration) {
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = -30.0, .restitution = 1.0});
  const Scaled soft{100.0, true};
  const Solution with = solve<AugmentedLagrangian>(problem, {.harmonics = 2, .penalty = soft});
  ASSERT_EQ(with.verdict, Verdict::converged) << with.message;
  EXPECT_LE((with.trajectory->sample(64).x.array() + 30.0).abs().maxCoeff(), 1e-9);
  const Solution without = solve<PenaltyHbm>(problem, {.common = {.harmonics = 2}, .penalty = soft});
  ASSERT_EQ(without.verdict, Verdict::converged) << without.message;
  EXPECT_GE((without.trajectory->sample(64).x.array() + 30.0).abs().maxCoeff(), 0.1);
}

TEST(AugmentedLagrangian, ApproachesTheRestitutionOneOrbit) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  std::vector<double> errors;
  for (const int harmonics : {5, 20, 80}) {
    const Solution solution = solve<AugmentedLagrangian>(test::to_problem(kStop), {.harmonics = harmonics});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    errors.push_back(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
}

TEST(AugmentedLagrangian, SolvesASpringByItsOwnStiffnessWithoutAnUpdate) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{80.0}});
  const Solution solution = solve<AugmentedLagrangian>(problem, {.harmonics = 12});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("0 updates"), std::string::npos) << solution.message;
  const Samples samples = solution.trajectory->sample(100);
  for (int i = 0; i < 100; ++i)
    EXPECT_NEAR(samples.force(i, 0), -80.0 * std::max(0.0, samples.x(i, 0) - 0.2), 1e-9);
  // Another penalty than the spring's leads to the spring all the same, up to the truncation of the series.
  const Solution other =
      solve<AugmentedLagrangian>(problem, {.harmonics = 12, .penalty = Scaled{60.0, false}});
  ASSERT_EQ(other.verdict, Verdict::converged) << other.message;
  EXPECT_LE(test::relative_distance(*solution.trajectory, *other.trajectory), 1e-3);
}

// A path of pivots over all nodes of ten contacts is long; a march is none.
TEST(AugmentedLagrangian, BeginsAtAMarchWhereContactsAreMany) {
  Problem problem = test::massless_beam({.alpha = 0.2, .beta = 0.02}, 10);
  const auto expect_marched = [](const Solution& solution) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_EQ(solution.message.rfind("from a march: solved", 0), 0U) << solution.message;
    EXPECT_EQ(solution.work.pivots, 0);
  };
  const Solution rigid = solve<AugmentedLagrangian>(problem, {.harmonics = 40});
  expect_marched(rigid);
  const Solution lipschitz = solve<FourierLipschitz>(problem, {.common = {.harmonics = 40}});
  EXPECT_LE(test::relative_distance(*rigid.trajectory, *lipschitz.trajectory), 0.1);  // other constants
  problem.set_law(Penalty{std::vector<double>(10, 10.0)});
  const Solution sprung = solve<AugmentedLagrangian>(problem, {.harmonics = 40});
  expect_marched(sprung);
  const Solution same = solve<PenaltyHbm>(problem, {.common = {.harmonics = 40}});
  ASSERT_EQ(same.verdict, Verdict::converged) << same.message;
  EXPECT_LE(test::relative_distance(*sprung.trajectory, *same.trajectory), 1e-10);
  const Solution plain = solve<AugmentedLagrangian>(problem, {.harmonics = 40, .plain = true});
  EXPECT_EQ(plain.message.find("march"), std::string::npos) << plain.message;
}

// Damping that is no combination of mass and stiffness leaves no reduced structure to march.
TEST(AugmentedLagrangian, BeginsAtFewHarmonicsWhereNothingMarches) {
  const Problem shaft = load_scene(find_scene("shaft-12-facets"));
  const Solution solution = solve<AugmentedLagrangian>(shaft, {.harmonics = 80});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.message.rfind("from few harmonics: solved", 0), 0U) << solution.message;
  const Solution same = solve<PenaltyHbm>(shaft, {.common = {.harmonics = 80}});
  ASSERT_EQ(same.verdict, Verdict::converged) << same.message;
  EXPECT_LE(test::relative_distance(*solution.trajectory, *same.trajectory), 1e-8);
}

TEST(AugmentedLagrangian, SaysWhichLawItRepresents) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.5});
  EXPECT_EQ(std::get<Restitution>(AugmentedLagrangian({}).law(problem)).e, 1.0);
  problem.set_law(Penalty{{80.0}});
  EXPECT_TRUE(law_matches(AugmentedLagrangian({.penalty = Scaled{10.0, true}}).law(problem), problem.law()));
}

TEST(AugmentedLagrangian, RefusesOptionsOutOfRange) {
  EXPECT_THROW(AugmentedLagrangian({.penalty = Scaled{0.0, false}}), InvalidOption);
  EXPECT_THROW(AugmentedLagrangian({.max_updates = 0}), InvalidOption);
  EXPECT_THROW(AugmentedLagrangian({.harmonics = 0}), InvalidOption);
}

}  // namespace
}  // namespace signorini::augmented_lagrangian_test
