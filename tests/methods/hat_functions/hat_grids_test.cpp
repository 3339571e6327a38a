#include "methods/hat_functions/hat_grids.hpp"

#include <gtest/gtest.h>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

Problem loaded_at(int harmonic, int subharmonic = 1) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = 0.8});
  problem.force = {{0, harmonic, 1.0, 0.0}};
  problem.subharmonic = subharmonic;
  return problem;
}

TEST(CoarsestHatGrid, HasSixteenNodesPerOscillationOfTheLoadFrom256To4096) {
  EXPECT_EQ(coarsest_hat_grid(loaded_at(1)), 256);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(16)), 256);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(17)), 512);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(10, 4)), 1024);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(10000)), 4096);
}

TEST(HatGrids, HaveFourTimesAsManyNodesEachUpToTheFinest) {
  const Problem problem = loaded_at(1);
  Resolutions grids = hat_grids(problem, {.samples = 7}, 0.8);
  ASSERT_EQ(grids.count(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(grids.value(k), 256 << 2 * k);
  // Each prepared for its own number of nodes, not for that of the settings.
  EXPECT_EQ(grids.at(0).solve({}).work.unknowns, 256);
}

TEST(RefinedHatContact, AgreesOnTwoGridsBeforeItAnswers) {
  const Problem problem = loaded_at(1);
  const Solution solution = refined_hat_contact(problem, {}, 0.8)->solve({});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_GE(solution.work.unknowns, 1024);
  EXPECT_NE(solution.message.find("N = "), std::string::npos);
}

}  // namespace
}  // namespace signorini
