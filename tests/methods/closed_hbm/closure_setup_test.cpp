#include "methods/closed_hbm/closure_setup.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::closure_setup_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

std::optional<ClosureSetup> closure_of(const Problem& problem, const ClosureSettings& settings = {}) {
  const LawAt law = [&problem](const ContactReceptance& level) { return lipschitz_law(problem, {}, level); };
  return closure_setup(harmonic_setup(problem, 20, {}, {.law_at = law, .grid_solver = lcp_grid_solver({})}),
                       settings);
}

TEST(ClosureSetup, IsThereWhereAMassMeetsARigidStop) {
  const Problem rigid = test::to_problem(kStop);
  EXPECT_TRUE(closure_of(rigid));
  Problem spring = rigid;
  spring.set_law(Penalty{{100.0}});
  EXPECT_FALSE(closure_of(spring));
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

TEST(ClosureSetup, AnswersToImpactsWithAllModesThatTheyExcite) {
  const Problem single = test::to_problem(kStop), fast = with_a_fast_mode();
  EXPECT_EQ(closure_of(single)->response->harmonics(), 128);
  const ContactReceptance response = *closure_of(fast)->response;
  EXPECT_GE(response.harmonics(), 512);
  const double base = fast.base_frequency();
  EXPECT_NEAR(inertial_limit(response).a(0, 0) * base * base, 1.0, 1e-4) << "the mass that is struck is 1 kg";
}

// The contact of this node has no mass: at restitution 1 its force stays as the series has it.
TEST(ClosureSetup, IsNoneAtRestitutionOneWhereNoMassIsStruck) {
  Problem problem = test::massless_node();
  problem.set_law(Restitution{1.0});
  EXPECT_FALSE(closure_of(problem));
  problem.set_law(Restitution{0.5});
  const std::optional<ClosureSetup> closure = closure_of(problem, {.restitution = 0.5});
  ASSERT_TRUE(closure);
  EXPECT_FALSE(closure->response);
  EXPECT_FALSE(closure->hat_grids);
}

TEST(ClosureSetup, AsksHatFunctionsFromCoarseToFineAndNoneForManyContacts) {
  Problem problem = test::to_problem(kStop);
  const std::optional<ClosureSetup> closure = closure_of(problem);
  ASSERT_EQ(closure->hat_grids->count(), 3U);
  EXPECT_EQ(closure->hat_grids->value(0), 256);
  EXPECT_EQ(closure->hat_grids->value(2), 4096);
  const Contact contact = problem.contacts.front();
  while (problem.contact_count() <= 32) problem.contacts.push_back(contact);
  EXPECT_FALSE(closure_of(problem)->hat_grids);
}

TEST(ClosureSetup, LooksForImpactsOnHatFunctionsOfItsRestitution) {
  test::ImpactOscillator scene = kStop;
  scene.restitution = 0.5;
  const Problem problem = test::to_problem(scene);
  std::optional<ClosureSetup> closure = closure_of(problem, {.restitution = 0.5});
  EXPECT_EQ(closure->restitution, 0.5);
  ASSERT_TRUE(closure->hat_grids);
  EXPECT_GE(closure->response->harmonics(), 128);
  const Solution hat = closure->hat_grids->solve_at(0, {});
  ASSERT_EQ(hat.verdict, Verdict::converged);
  // The velocities about the one impact, from the nodes before and after those that it presses.
  const Samples nodes = hat.trajectory->sample(256);
  Eigen::Index hit = 0;
  nodes.force.col(0).minCoeff(&hit);
  const auto at = [&](Eigen::Index i) { return nodes.velocity((hit + i + 256) % 256, 0); };
  EXPECT_NEAR(-at(2) / at(-3), 0.5, 0.1);
}

TEST(ClosureSetup, LeavesAConstantThatTheUserChose) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_EQ(closure_of(problem)->stiffness_factor, 8.0);
  EXPECT_EQ(closure_of(problem, {.constant_is_chosen = true})->stiffness_factor, 1.0);
}

}  // namespace
}  // namespace signorini::closure_setup_test
