#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <gtest/gtest.h>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

const HarmonicOptions kNone{.restitution = ClosedRestitution::none};  // impacts compensated, not closed

HarmonicSetup setup_of(const Problem& problem, const HarmonicOptions& options, bool solver_is_open = true,
                       bool constant_is_chosen = false) {
  const LawAt law = [&problem](const ContactReceptance& level) { return lipschitz_law(problem, {}, level); };
  return harmonic_setup(problem, 20, options,
                        {.law_at = law,
                         .grid_solver = lcp_grid_solver({}),
                         .constant_is_chosen = constant_is_chosen,
                         .solver_is_open = solver_is_open});
}

TEST(HarmonicSetup, HoldsTheEquationsOfTheScene) {
  const Problem problem = test::to_problem(kStop);
  const HarmonicSetup setup = setup_of(problem, {});
  EXPECT_EQ(setup.receptance.harmonics(), 20);
  EXPECT_EQ(setup.gap[0], 0.2);
  EXPECT_EQ(setup.problem, &problem);
  EXPECT_EQ(&setup.equations().law, &setup.law);
  EXPECT_EQ(setup.law.constant, setup.method.law_at(setup.receptance).constant);
}

TEST(HarmonicSetup, CompensatesImpactsOfAMassOnARigidStop) {
  const Problem rigid = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(rigid, {}).compensation);
  EXPECT_FALSE(setup_of(rigid, {.compensate = false}).compensation);
  EXPECT_FALSE(setup_of(rigid, {.plain = true}).compensation);
  Problem spring = rigid;
  spring.law = Penalty{{100.0}};
  EXPECT_FALSE(setup_of(spring, {}).compensation);
}

TEST(HarmonicSetup, AsksHatFunctionsOnlyWhereTheSolverIsOpenAndImpactsAreCompensated) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(problem, kNone).hat_grids);
  EXPECT_FALSE(setup_of(problem, kNone, false).hat_grids);
  EXPECT_FALSE(setup_of(problem, {.compensate = false}).hat_grids);
}

TEST(HarmonicSetup, AsksHatFunctionsFromCoarseToFineAndNoneForManyContacts) {
  Problem problem = test::to_problem(kStop);
  const HarmonicSetup setup = setup_of(problem, {});
  ASSERT_EQ(setup.hat_grids->count(), 3U);
  EXPECT_EQ(setup.hat_grids->value(0), 256);
  EXPECT_EQ(setup.hat_grids->value(2), 4096);
  const Contact contact = problem.contacts.front();
  while (problem.contact_count() <= 32) problem.contacts.push_back(contact);
  EXPECT_FALSE(setup_of(problem, {}).hat_grids);
}

TEST(HarmonicSetup, ClosesImpactsAtTheScenesRestitutionFromHatFunctionsThatHaveIt) {
  test::ImpactOscillator scene = kStop;
  scene.restitution = 0.5;
  const Problem problem = test::to_problem(scene);
  EXPECT_FALSE(setup_of(problem, {.restitution = ClosedRestitution::none}).restitution);
  HarmonicSetup setup = setup_of(problem, {}, false);
  EXPECT_EQ(setup.restitution, 0.5);
  ASSERT_TRUE(setup.hat_grids) << "whatever the solver";
  EXPECT_GE(setup.compensation->receptance().harmonics(), 128);
  const Solution hat = setup.hat_grids->solve_at(0, {});
  ASSERT_EQ(hat.verdict, Verdict::converged);
  // The velocities about the one impact, from the nodes before and after those that it presses.
  const Samples nodes = hat.trajectory->sample(256);
  Eigen::Index hit = 0;
  nodes.force.col(0).minCoeff(&hit);
  const auto at = [&](Eigen::Index i) { return nodes.velocity((hit + i + 256) % 256, 0); };
  EXPECT_NEAR(-at(2) / at(-3), 0.5, 0.1);
}

TEST(HarmonicSetup, SolvesWithoutAGridOnlyWhereNothingFixesIt) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(problem, {}).without_grid());
  EXPECT_FALSE(setup_of(problem, {}, false).without_grid());
  EXPECT_FALSE(setup_of(problem, {.samples = 640}).without_grid());
  EXPECT_EQ(setup_of(problem, {.samples = 640}).options.samples, 640);
}

TEST(HarmonicSetup, LeavesAConstantThatTheUserChose) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_EQ(setup_of(problem, {}).compensated_stiffness(), 8.0);
  EXPECT_EQ(setup_of(problem, {}, true, true).compensated_stiffness(), 1.0);
}

}  // namespace
}  // namespace signorini
