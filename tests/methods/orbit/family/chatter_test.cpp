// Complete chatter along a curve, against closed forms: the motion that leaves the stop does not know of the
// impacts before it came to rest.

#include "methods/orbit/family/chatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::chatter_test {
namespace {

using test::polished;

struct Row {
  double damping, frequency, gap, e, release, impact, speed, limit;
};

test::ImpactOscillator oscillator(const Row& row) {
  return {.damping = row.damping, .frequency = row.frequency, .gap = row.gap, .restitution = row.e};
}

// The branches through the orbit that the oscillator comes to.
OrbitDiagram diagram_through(OrbitFamily& family, const Problem& problem, double parameter) {
  const auto found = test::cold_orbit(problem);
  EXPECT_TRUE(found.orbit) << found.solution.message;
  const SequencedOrbit seed =
      sequenced(family, found.orbit->orbit(), problem.period(), problem.frequency, parameter);
  return trace_diagram(family, {seed}, {.max_order = 1});
}

// First impact of a period after the release, its speed, the release and the limit of the impacts; times less
// whole periods.
struct Chatter {
  double release = 0.0, impact = 0.0, speed = 0.0, limit = 0.0;
  std::size_t impacts = 0;
};

Chatter chatter_of(ExtendedEquations& equations) {
  const SequencedOrbit& orbit = equations.orbit();
  const double e = equations.model().dynamics.restitution(0);
  Chatter found;
  std::size_t open = 0;
  while (orbit.events[open].kind != ContactEvent::Kind::open) ++open;
  const std::size_t first = (open + 1) % orbit.events.size();
  found.release = equations.time_of(orbit.phase(static_cast<Eigen::Index>(open)));
  found.impact = equations.time_of(orbit.phase(static_cast<Eigen::Index>(first)));
  found.speed = equations.equations().crossings()[first].approach;
  const std::vector<ChatterEnd> ends = chatter_ends(equations);
  EXPECT_EQ(ends.size(), 1U);
  found.limit = equations.time_of(orbit.phase(ends[0].closing)) +
                2.0 * e * ends[0].speed / (ends[0].acceleration * (1.0 - e));
  found.impacts = orbit.events.size() - 1;
  return found;
}

// The closed forms and sums of impacts of the exact orbits' table, reached along the curve from elsewhere.
TEST(Chatter, IsFollowedToTheValuesOfTheTable) {
  for (const auto& [row, from, to, start] :
       {std::tuple(Row{0.02, 0.5, 0.2, 0.5, 2.7388768120, 9.4661871002, 1.2476540087, 14.4431813264}, 0.35,
                   0.6, 0.4),
        std::tuple(Row{0.02, 0.25, 0.0, 0.8, 6.2831853072, 18.8711841977, 0.5017858118, 26.9041317069}, 0.2,
                   0.3, 0.28)}) {
    SCOPED_TRACE(row.e);
    Problem problem = test::to_problem(oscillator(row));
    OrbitFamily family(over_frequency(problem, from, to));
    problem.frequency = start;
    const OrbitDiagram diagram = diagram_through(family, problem, start);
    std::size_t found = 0;
    for (const OrbitBranch& branch : diagram.branches) {
      for (const SequencedOrbit& orbit : orbits_at(family, branch, row.frequency)) {
        ExtendedEquations equations(family, orbit);
        ASSERT_TRUE(equations.evaluate(orbit.x));
        if (chatter_ends(equations).empty()) continue;
        ++found;
        const Chatter chatter = chatter_of(equations);
        const double T = kTwoPi / row.frequency;
        EXPECT_NEAR(std::remainder(chatter.release - row.release, T), 0.0, 2e-10);
        EXPECT_NEAR(std::remainder(chatter.impact - row.impact, T), 0.0, 2e-10);
        EXPECT_NEAR(chatter.speed, row.speed, 2e-10);
        EXPECT_NEAR(std::remainder(chatter.limit - row.limit, T), 0.0, 2e-8);
      }
    }
    EXPECT_EQ(found, 1U);
  }
}

TEST(Chatter, HasAsManyImpactsAsItNeedsAndEndsAtItsLimit) {
  const Row row{0.02, 0.5, 0.2, 0.5, 0.0, 0.0, 0.0, 0.0};
  Problem problem = test::to_problem(oscillator(row));
  OrbitFamily family(over_frequency(problem, 0.3, 0.9));
  problem.frequency = 0.4;
  const OrbitDiagram diagram = diagram_through(family, problem, 0.4);
  ASSERT_FALSE(diagram.branches.empty());
  const OrbitBranch& branch = diagram.branches.front();
  EXPECT_TRUE(branch.ended.starts_with(kChatterLimit) || branch.began.starts_with(kChatterLimit))
      << branch.began << "; " << branch.ended;
  // Found before at .524795 with 12 impacts resolved, at .524568 with 19.
  const double limit = std::max(branch.points.front().parameter, branch.points.back().parameter);
  EXPECT_NEAR(limit, 0.5245, 2e-4);
  EXPECT_NEAR(std::min(branch.points.front().parameter, branch.points.back().parameter), 0.3, 1e-12);
  std::size_t least = 1000, most = 0;
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const SolutionPoint& point = branch.points[i];
    const ExactOrbit orbit = polished(family.scene(), branch, i);
    EXPECT_TRUE(orbit.certified()) << point.parameter << ": " << orbit.reason;
    EXPECT_EQ(point.stability, OrbitStability::stable);
    EXPECT_LE(point.x_max[0], 0.2 + 1e-11);
    least = std::min(least, branch.orbits[i].events.size());
    most = std::max(most, branch.orbits[i].events.size());
  }
  EXPECT_GE(least, 10U);
  EXPECT_GT(most, least);
  EXPECT_LE(most, 60U);
}

// Release, first impact and its speed are those of any restitution; the impacts after it are more, the larger
// it is.
TEST(Chatter, ForgetsTheRestitutionAlongACurveOfIt) {
  const Row row{0.02, 0.5, 0.2, 0.5, 2.7388768120, 9.4661871002, 1.2476540087, 0.0};
  const ParametrisedScene scene{.parameter = "law.restitution", .from = 0.2, .to = 0.5, .at = [&](double e) {
                                  Row other = row;
                                  other.e = e;
                                  return test::to_problem(oscillator(other));
                                }};
  OrbitFamily family(scene);
  const OrbitDiagram diagram = diagram_through(family, scene.at(0.45), 0.45);
  ASSERT_FALSE(diagram.branches.empty());
  std::size_t impacts = 0;
  for (const double e : {0.2, 0.3, 0.4, 0.5}) {
    const auto orbits = orbits_at(family, diagram.branches.front(), e);
    ASSERT_EQ(orbits.size(), 1U) << e;
    ExtendedEquations equations(family, orbits.front());
    ASSERT_TRUE(equations.evaluate(orbits.front().x));
    const Chatter chatter = chatter_of(equations);
    EXPECT_NEAR(std::remainder(chatter.release - row.release, kTwoPi / 0.5), 0.0, 2e-10);
    EXPECT_NEAR(std::remainder(chatter.impact - row.impact, kTwoPi / 0.5), 0.0, 2e-10);
    EXPECT_NEAR(chatter.speed, row.speed, 2e-10);
    EXPECT_GT(chatter.impacts, impacts);
    impacts = chatter.impacts;
  }
}

TEST(ChatterEnds, AreThoseOfRigidStopsThatGiveBack) {
  const Row row{0.02, 0.5, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0};
  const Problem problem = test::to_problem(oscillator(row));
  OrbitFamily family(over_frequency(problem, 0.45, 0.55));
  const auto found = test::cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const SequencedOrbit orbit = sequenced(family, found.orbit->orbit(), problem.period(), 0.5, 0.5);
  ExtendedEquations equations(family, orbit);
  ASSERT_TRUE(equations.evaluate(orbit.x));
  EXPECT_TRUE(chatter_ends(equations).empty());
  EXPECT_FALSE(resolve_chatter(equations).orbit.has_value());
  EXPECT_FALSE(leaves_out_too_much(equations));
}

}  // namespace
}  // namespace signorini::chatter_test
