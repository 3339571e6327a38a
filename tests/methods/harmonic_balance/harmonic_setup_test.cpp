#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <gtest/gtest.h>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::harmonic_setup_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

HarmonicSetup setup_of(const Problem& problem, const HarmonicOptions& options, bool solver_is_open = true) {
  const LawAt law = [&problem](const ContactReceptance& level) { return lipschitz_law(problem, {}, level); };
  return harmonic_setup(
      problem, 20, options,
      {.law_at = law, .grid_solver = lcp_grid_solver({}), .solver_is_open = solver_is_open});
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

TEST(HarmonicSetup, SolvesWithoutAGridOnlyWhereNothingFixesIt) {
  const Problem problem = test::to_problem(kStop);
  EXPECT_TRUE(setup_of(problem, {}).without_grid());
  EXPECT_FALSE(setup_of(problem, {}, false).without_grid());
  EXPECT_FALSE(setup_of(problem, {.samples = 640}).without_grid());
  EXPECT_EQ(setup_of(problem, {.samples = 640}).options.samples, 640);
}

}  // namespace
}  // namespace signorini::harmonic_setup_test
