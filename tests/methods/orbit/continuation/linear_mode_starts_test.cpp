// Nonlinear modes from the amplitude at which their linear ones reach a stop, against closed forms.

#include "methods/orbit/continuation/linear_mode_starts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/methods/orbit/continuation/diagrams.hpp"

namespace signorini::linear_mode_starts_test {
namespace {

constexpr double kPi = std::numbers::pi;

// One mass without damping or load before stops of one law.
Problem free_mass(double stiffness, double gap, const Law& law) {
  Problem problem;
  SparseMatrix one(1, 1), none(1, 1), spring(1, 1);
  one.insert(0, 0) = 1.0;
  spring.insert(0, 0) = stiffness;
  problem.edit_structure([&](Structure& structure) {
    structure.mass = one;
    structure.damping = none;
    structure.stiffness = spring;
  });
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = gap}};
  problem.set_law(law);
  return problem;
}

// Wall - m - m, masses and springs 1, between two stops at the distance 1 of the first mass.
Problem chain_between_stops(const Law& law) {
  Problem problem;
  problem.edit_structure([&](Structure& structure) {
    structure.mass = test::symmetric(1.0, 0.0, 1.0);
    structure.damping = SparseMatrix(2, 2);
    structure.stiffness = test::symmetric(2.0, -1.0, 1.0);
  });
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}, {.normal = {{0, -1.0}}, .gap = 1.0}};
  problem.set_law(law);
  return problem;
}

OrbitDiagram modes_of(const Problem& problem, double from, double to, const CurveLimits& limits = {},
                      const std::optional<ParameterRange>& energies = {}) {
  OrbitFamily family(over_frequency(problem, from, to));
  std::vector<CurveStart> starts;
  for (LinearModeStart& mode : linear_mode_starts(family).starts) starts.push_back(std::move(mode.start));
  return trace_diagram(family, {}, limits, {}, std::move(starts), energies);
}

// A half turn at w1 about 0 and one at w2 about the same place, the parts on either side of x = g.
double bilinear_frequency(double energy, double stiffness, double stop, double gap) {
  const double w1 = std::sqrt(stiffness), w2 = std::sqrt(stiffness + stop);
  const double amplitude = std::sqrt(2.0 * energy / stiffness);
  const double v = w1 * std::sqrt(amplitude * amplitude - gap * gap);
  const double open = 2.0 * (kPi - std::acos(gap / amplitude)) / w1;
  const double held = 2.0 / w2 * std::atan2(v / w2, gap * w1 * w1 / (w2 * w2));
  return 2.0 * kPi / (open + held);
}

// code_aster V5.01.122, whose own reference is 6e-4 off.
TEST(LinearModeStarts, LeadToTheModesOfAMassBeforeASpring) {
  const Problem problem = free_mass(10.0, 0.01, Penalty{{50.0}});
  OrbitFamily family(over_frequency(problem, 3.0, 4.48));
  const LinearModeStarts found = linear_mode_starts(family);
  ASSERT_EQ(found.starts.size(), 1U);
  EXPECT_NEAR(found.starts[0].frequency, std::sqrt(10.0), 1e-14);
  EXPECT_NEAR(found.starts[0].energy, 0.5 * 10.0 * 1e-4, 1e-17);
  const OrbitDiagram diagram = modes_of(problem, 3.0, 4.48);
  ASSERT_EQ(diagram.branches.size(), 1U);
  const OrbitBranch& branch = diagram.branches[0];
  EXPECT_EQ(branch.sequence, "order 1, events C0 O0");
  EXPECT_EQ(branch.ended, kEndOfInterval);
  EXPECT_GT(branch.points.size(), 50U);
  for (const SolutionPoint& point : branch.points) {
    EXPECT_EQ(point.stability, OrbitStability::elliptic);
    if (*point.energy < 0.000500001) continue;
    EXPECT_NEAR(bilinear_frequency(*point.energy, 10.0, 50.0, 0.01), point.frequency, 1e-10);
  }
}

TEST(LinearModeStarts, AreFollowedByTheirEnergyToo) {
  constexpr double kFirst = 0.00650108331626, kLast = 0.00658129654238;
  const OrbitDiagram diagram = modes_of(free_mass(10.0, 0.01, Penalty{{50.0}}), 3.0, 4.48, {.at = {kFirst}},
                                        ParameterRange{.low = 4e-4, .high = kLast});
  ASSERT_EQ(diagram.branches.size(), 1U);
  const std::vector<SolutionPoint>& points = diagram.branches[0].points;
  const auto at = std::ranges::find_if(
      points, [](const SolutionPoint& point) { return std::abs(*point.energy - kFirst) < 1e-15; });
  ASSERT_NE(at, points.end());
  EXPECT_NEAR(at->frequency / (2.0 * kPi), 0.6466310406, 1e-10);
  EXPECT_NEAR(*points.back().energy, kLast, 1e-15);
  EXPECT_NEAR(points.back().frequency / (2.0 * kPi), 0.6470147154, 1e-10);
}

// Pressed at rest, the contact lets go at large amplitudes: the mode softens.
TEST(LinearModeStarts, LeadToTheModesOfAPressedSpring) {
  constexpr double k = 1.0, kc = 8.0, g = -0.3, w1 = 1.0, w2 = 3.0;
  const double rest = kc * g / (k + kc);
  const OrbitDiagram diagram = modes_of(free_mass(k, g, Penalty{{kc}}), 1.6, 3.5);
  ASSERT_EQ(diagram.branches.size(), 1U);
  const OrbitBranch& branch = diagram.branches[0];
  EXPECT_NEAR(branch.points.front().frequency, w2, 1e-13);
  EXPECT_NEAR(branch.points.back().frequency, 1.6, 1e-12);
  for (const SolutionPoint& point : branch.points) {
    const double a = point.x_max[0] - rest, reach = rest - g;  // about the rest; to where it lets go
    if (a < 1.0001 * reach) continue;
    const double v = w2 * std::sqrt(a * a - reach * reach);
    const double held = 2.0 * (kPi - std::acos(reach / a)) / w2;
    const double open = 2.0 * std::acos(-g / std::hypot(g, v / w1)) / w1;
    EXPECT_NEAR(2.0 * kPi / (held + open), point.frequency, 1e-10);
  }
}

// A ball on a spring under its weight: free flight over 2 v / g, contact over (pi + 2 phi) / w, v the speed
// between both, tan phi = g / (w v).
TEST(LinearModeStarts, LeadToTheFlightsOfABallOnASpring) {
  constexpr double kc = 4.0, w = 2.0, g = 9.81;
  Problem problem = free_mass(0.0, 0.0, Penalty{{kc}});
  problem.force = {{.dof = 0, .harmonic = 0, .cos = g}};
  const auto band = free_motion_band(problem);
  ASSERT_TRUE(band);
  EXPECT_NEAR(band->low, 0.1 * w, 1e-12);
  const OrbitDiagram diagram = modes_of(problem, band->low, band->high);
  ASSERT_EQ(diagram.branches.size(), 1U);
  const OrbitBranch& branch = diagram.branches[0];
  EXPECT_NEAR(branch.points.front().frequency, w, 1e-12);
  EXPECT_EQ(branch.ended, kEndOfInterval);
  for (const SolutionPoint& point : branch.points) {
    const double v =
        std::sqrt(2.0 * std::max(0.0, *point.energy));  // at the stop the weight has done no work
    if (v < 1e-3 * g / w) continue;
    EXPECT_NEAR(2.0 * kPi / (2.0 * v / g + (kPi + 2.0 * std::atan2(g / w, v)) / w), point.frequency, 1e-10);
  }
}

// code_aster V5.01.123, mode 2: shooting by another program, to 1e-11.
TEST(LinearModeStarts, LeadToTheModesBetweenTwoSprings) {
  const double first = 2.0 * kPi * 0.25790528513;
  const std::vector<std::pair<double, double>> energies{
      {1.62, 1.818983255}, {first, 1.820200676}, {1.64, 1.841463707}};
  const OrbitDiagram diagram =
      modes_of(chain_between_stops(Penalty{{30.0, 30.0}}), 1.6, 1.8, {.at = {1.62, first, 1.64}});
  ASSERT_EQ(diagram.branches.size(), 1U);
  for (const auto& [frequency, energy] : energies) {
    int met = 0;
    double largest = 0.0;
    for (const SolutionPoint& point : diagram.branches[0].points) {
      if (std::abs(point.frequency - frequency) > 1e-12) continue;
      EXPECT_NEAR(*point.energy, energy, 1e-9);
      EXPECT_EQ(point.impacts, 2);
      largest = point.x_max[0];
      ++met;
    }
    EXPECT_EQ(met, 1) << frequency;
    if (frequency == first) {
      EXPECT_NEAR(largest, 1.00458363, 1e-8);
    }
  }
}

// With rigid stops in place of the springs: half a period after an impact J = g / S the other stop is struck
// likewise, S = sum phi_r^2 tan(w_r pi / (2 Omega)) / (2 w_r), so that E = J^2 / 8 sum phi_r^2 / cos^2.
TEST(LinearModeStarts, LeadToAntisymmetricMotionsBetweenRigidStops) {
  const OrbitDiagram diagram = modes_of(chain_between_stops(Restitution{1.0}), 1.6, 1.8);
  int compared = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    if (!branch.began.starts_with("mode 2")) continue;
    EXPECT_NEAR(branch.points.front().frequency, 0.5 * (1.0 + std::sqrt(5.0)), 1e-13);
    EXPECT_NEAR(branch.points.back().frequency, 1.8, 1e-12);
    for (const SolutionPoint& point : branch.points) {
      double S = 0.0, spread = 0.0;
      for (const double square : {0.5 * (3.0 - std::sqrt(5.0)), 0.5 * (3.0 + std::sqrt(5.0))}) {
        const double w = std::sqrt(square), phi = 1.0 / (1.0 + (2.0 - square) * (2.0 - square));
        const double quarter = 0.5 * w * kPi / point.frequency;
        S += phi * std::tan(quarter) / (2.0 * w);
        spread += phi / (std::cos(quarter) * std::cos(quarter));
      }
      if (point.frequency < 1.6185) continue;
      EXPECT_NEAR(*point.energy, spread / (8.0 * S * S), 1e-9 * *point.energy) << point.frequency;
      EXPECT_EQ(point.impacts, 2);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(LinearModeStarts, SayWhyThereAreNone) {
  const auto obstacle = [](const Problem& problem) {
    OrbitFamily family(over_frequency(problem, 0.5, 3.0));
    const LinearModeStarts found = linear_mode_starts(family);
    EXPECT_TRUE(found.starts.empty());
    return found.obstacle;
  };
  EXPECT_EQ(obstacle(free_mass(1.0, 0.0, Penalty{{8.0}})),
            "a stop is touched at rest, where the frequency does not depend on the energy");
  EXPECT_EQ(obstacle(free_mass(1.0, -0.1, Restitution{1.0})), "a rigid stop is pressed at rest");
  EXPECT_EQ(obstacle(free_mass(0.0, 0.1, Restitution{1.0})), "no spring holds the structure in place");
}

}  // namespace
}  // namespace signorini::linear_mode_starts_test
