#include "methods/hat_functions/hat_strategy.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>
#include <optional>

#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// A scene on one grid, everything that a HatProblem refers to.
class OnGrid {
 public:
  OnGrid(const test::ImpactOscillator& oscillator, const HatSettings& grid)
      : scene(test::to_problem(oscillator)),
        settings(grid),
        stops(nodal_stops(scene, oscillator.restitution)),
        form(hat_form(contact_receptance(scene, grid.samples / 2,
                                         [&](int n) {
                                           return scheme_weights(grid.scheme,
                                                                 2.0 * std::numbers::pi * n / grid.samples,
                                                                 scene.period() / grid.samples);
                                         }),
                      stops, grid.samples)) {}

  LcpResult solve(const Start& start = {}) {
    return solve_hat_problem({scene, stops, form, settings}, start);
  }

  Problem scene;
  HatSettings settings;
  NodalStops stops;
  HatForm form;
};

const test::ImpactOscillator kImpacts{.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = 0.8};

TEST(SolveHatProblem, FindsTheSameContactByEverySolverThatConverges) {
  OnGrid automatic(kImpacts, {.samples = 128});
  const LcpResult expected = automatic.solve();
  ASSERT_EQ(expected.status, LcpStatus::solved);
  EXPECT_LE(natural_residual(automatic.form.lcp, expected.z), 1e-10);
  OnGrid pivoting(kImpacts, {.samples = 128, .solver = ComplementaritySolver::pivoting});
  const LcpResult by_pivots = pivoting.solve();
  ASSERT_EQ(by_pivots.status, LcpStatus::solved);
  EXPECT_LE((by_pivots.z - expected.z).norm(), 1e-8 * expected.z.norm());
}

TEST(SolveHatProblem, KeepsToTheLimitOnPivots) {
  OnGrid limited(kImpacts, {.samples = 128, .max_iterations = 2});
  const LcpResult result = limited.solve();
  EXPECT_EQ(result.status, LcpStatus::limit);
  EXPECT_EQ(result.pivots, 2);
}

TEST(SolveHatProblem, RecognisesPermanentContactWithoutAPivot) {
  OnGrid pressed({.damping = 0.1, .frequency = 1.5, .gap = -3.0, .restitution = 0.0}, {.samples = 64});
  const LcpResult result = pressed.solve();
  ASSERT_EQ(result.status, LcpStatus::solved);
  EXPECT_GT(result.z.minCoeff(), 0.0);
  EXPECT_EQ(result.pivots, 0);
}

// Complete chatter of an inelastic contact: the path is long, marching is not.
TEST(SolveHatProblem, LeavesALongPathForMarching) {
  const test::ImpactOscillator chatter{.damping = 0.02, .frequency = 0.25, .gap = 0.0, .restitution = 0.5};
  OnGrid automatic(chatter, {.samples = 512});
  const LcpResult result = automatic.solve();
  ASSERT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE(result.pivots, 104 * 512);
  EXPECT_LE(natural_residual(automatic.form.lcp, result.z), 1e-10);
}

}  // namespace
}  // namespace signorini
