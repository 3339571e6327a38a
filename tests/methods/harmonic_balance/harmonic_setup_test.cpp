#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <gtest/gtest.h>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::harmonic_setup_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

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

TEST(HarmonicSetup, ClosesImpactsOfAMassOnARigidStop) {
  const Problem rigid = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(rigid, {}).closure);
  EXPECT_FALSE(setup_of(rigid, {.compensate = false}).closure);
  EXPECT_FALSE(setup_of(rigid, {.plain = true}).closure);
  Problem spring = rigid;
  spring.law = Penalty{{100.0}};
  EXPECT_FALSE(setup_of(spring, {}).closure);
}

// The scene with a mass of 0.1 kg on a damped spring behind its own, with a mode some 100 times as fast as
// the load.
Problem with_a_fast_mode() {
  constexpr double kAttached = 0.1, kFast = 100.0 * 2.2, kDampingRatio = 0.15;
  Problem problem = test::to_problem(kStop);
  problem.edit_structure([](Structure& structure) {
    const auto with = [](const SparseMatrix& own, double attached, double between) {
      Eigen::Matrix2d A;
      A << own.coeff(0, 0) + between, -between, -between, attached + between;
      return SparseMatrix(A.sparseView());
    };
    structure.mass = with(structure.mass, kAttached, 0.0);
    structure.damping = with(structure.damping, 0.0, 2.0 * kDampingRatio * kAttached * kFast);
    structure.stiffness = with(structure.stiffness, 0.0, kAttached * kFast * kFast);
  });
  return problem;
}

TEST(HarmonicSetup, AnswersToImpactsWithAllModesThatTheyExcite) {
  const Problem single = test::to_problem(kStop), fast = with_a_fast_mode();
  EXPECT_EQ(setup_of(single, {}).closure->response->harmonics(), 128);
  const ContactReceptance response = *setup_of(fast, {}).closure->response;
  EXPECT_GE(response.harmonics(), 512);
  const double base = fast.base_frequency();
  EXPECT_NEAR(inertial_limit(response).a(0, 0) * base * base, 1.0, 1e-4) << "the mass that is struck is 1 kg";
}

// At restitution 1, which a series has, a solver that is set finds its impacts itself.
TEST(HarmonicSetup, AsksHatFunctionsForImpactsUnlessASolverIsSetThatMayFindThem) {
  Problem problem = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(problem, {}).closure->hat_grids);
  EXPECT_FALSE(setup_of(problem, {}).closes_own_series());
  EXPECT_FALSE(setup_of(problem, {}, false).closure->hat_grids);
  EXPECT_TRUE(setup_of(problem, {}, false).closes_own_series());
  problem.law = Restitution{0.5};
  EXPECT_TRUE(setup_of(problem, {}, false).closure->hat_grids);
  const HarmonicOptions elastic{.restitution = ClosedRestitution::none};
  EXPECT_TRUE(setup_of(problem, elastic, false).closes_own_series());
}

// The contact of this node has no mass: at restitution 1 its force stays as the series has it.
TEST(HarmonicSetup, ClosesNothingAtRestitutionOneWhereNoMassIsStruck) {
  Problem problem = test::massless_node();
  problem.law = Restitution{1.0};
  EXPECT_FALSE(setup_of(problem, {}).closure);
  problem.law = Restitution{0.5};
  ASSERT_TRUE(setup_of(problem, {}).closure);
  EXPECT_FALSE(setup_of(problem, {}).closure->response);
}

TEST(HarmonicSetup, AsksHatFunctionsFromCoarseToFineAndNoneForManyContacts) {
  Problem problem = test::to_problem(kStop);
  const HarmonicSetup setup = setup_of(problem, {});
  ASSERT_EQ(setup.closure->hat_grids->count(), 3U);
  EXPECT_EQ(setup.closure->hat_grids->value(0), 256);
  EXPECT_EQ(setup.closure->hat_grids->value(2), 4096);
  const Contact contact = problem.contacts.front();
  while (problem.contact_count() <= 32) problem.contacts.push_back(contact);
  EXPECT_FALSE(setup_of(problem, {}).closure->hat_grids);
}

TEST(HarmonicSetup, ClosesImpactsAtTheScenesRestitutionFromHatFunctionsThatHaveIt) {
  test::ImpactOscillator scene = kStop;
  scene.restitution = 0.5;
  const Problem problem = test::to_problem(scene);
  EXPECT_EQ(setup_of(problem, {.restitution = ClosedRestitution::none}).closure->restitution, 1.0);
  HarmonicSetup setup = setup_of(problem, {}, false);
  EXPECT_EQ(setup.closure->restitution, 0.5);
  ASSERT_TRUE(setup.closure->hat_grids) << "whatever the solver";
  EXPECT_GE(setup.closure->response->harmonics(), 128);
  const Solution hat = setup.closure->hat_grids->solve_at(0, {});
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
  EXPECT_EQ(setup_of(problem, {}).closed_stiffness(), 8.0);
  EXPECT_EQ(setup_of(problem, {}, true, true).closed_stiffness(), 1.0);
}

}  // namespace
}  // namespace signorini::harmonic_setup_test
