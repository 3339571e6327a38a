// Curves of exact orbits of scenes whose contacts have different laws: special points known from one law, and
// from a march in closed form that shares no code with ours, where a multiplier of its differences is -1 or 1
// to 1e-8.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "methods/orbit/continuation/contact_changes.hpp"
#include "methods/orbit/family/orbit_family.hpp"
#include "methods/orbit/starts/one_impact_orbits.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"

namespace signorini::mixed_law_curves_test {
namespace {

using test::branch_of;
using test::diagram_of;
using test::kLocated;
using test::nearest;
using test::polished;

/// m = k = F = 1, damping 0.1, between stops above and below, each the end of a [[contact]] table.
Problem between(const std::string& above, const std::string& below) {
  return parse_scene(
      "schema = 1\nname = \"s\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1\nstiffness = "
      "1.0\n[forcing]\nfrequency = 2.0\n[[forcing.term]]\ndof = 0\ncos = 1.0\n[[contact]]\ndof = 0\n" +
          above + "\n[[contact]]\ndof = 0\n" + below + "\n",
      "s.toml");
}

const std::string kRigid = "gap = 0.2\nrestitution = 0.8";

TEST(MixedLawCurves, OfAStopThatIsNeverReachedAreThoseOfOneLaw) {
  for (const char* other : {"penalty = 20.0", "restitution = 0.3", "penalty = 20.0\ndamper = 2.0"}) {
    const OrbitDiagram diagram =
        diagram_of(between(kRigid, "side = \"below\"\ngap = 50.0\n" + std::string(other)), 1.7, 4.4);
    const OrbitBranch *one = branch_of(diagram, 1, 1), *two = branch_of(diagram, 2, 1);
    ASSERT_TRUE(one && two) << other;
    EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, 2.265), 2.2652971759636, kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::period_doubling, 2.887), 2.8875236600941, kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::fold, 3.693), 3.6934249832280, kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::grazing, 2.423), 2.423367185351, kLocated);
  }
}

// Whether the mass beside the oscillator feels a damper to the ground, or nothing at all.
TEST(LoosePartCurves, BesideAnIdleMassAreThoseWithoutIt) {
  for (const char* damper : {"0.0", "0.3"}) {
    const Problem problem = parse_scene(
        std::string("schema = 1\nname = \"s\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 0.6]\n"
                    "dampers = [0.1, 0.0]\nsprings = [1.0, 0.0]\nground_springs = [0.0, 0.0]\n"
                    "ground_dampers = [0.0, ") +
            damper +
            "]\n[forcing]\nfrequency = 2.0\nterm = [{ dof = 0, cos = 1.0 }]\n[[contact]]\ndof = 0\n" +
            kRigid + "\n",
        "s.toml");
    const OrbitDiagram diagram = diagram_of(problem, 1.9, 2.6);
    const OrbitBranch* one = branch_of(diagram, 1, 1);
    ASSERT_TRUE(one) << damper;
    EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, 2.265), 2.2652971759636, kLocated) << damper;
  }
}

TEST(LoosePartCurves, AreRefusedOfPartsThatMayBeAnywhereAsOne) {
  const auto pair = [](const char* spring) {
    return parse_scene(
        std::string("schema = 1\nname = \"s\"\n[system]\nkind = \"chain\"\nmasses = [1.3, 0.7, 0.9]\n"
                    "dampers = [0.0, 0.1, 0.05]\nsprings = [") +
            spring +
            ", 1.7, 2.3]\n[forcing]\nfrequency = 1.9\nterm = [{ dof = 0, cos = 0.8 }]\n[[contact]]\n"
            "between = [0, 2]\ngap = 0.15\nrestitution = 0.6\n",
        "s.toml");
  };
  EXPECT_NE(continuation_obstacle(pair("0.0")).find("hold one of them by a weak spring"), std::string::npos);
  EXPECT_EQ(continuation_obstacle(pair("0.01")), "");
}

struct Located {
  std::string above, below;
  std::vector<std::pair<SpecialKind, double>> points;
};

TEST(MixedLawCurves, HaveTheSpecialPointsOfAnIndependentMarch) {
  constexpr auto kFold = SpecialKind::fold, kDoubling = SpecialKind::period_doubling;
  const std::vector<Located> all{
      {kRigid,
       "side = \"below\"\ngap = 0.5\npenalty = 20.0",
       {{kFold, 2.250975801890}, {kDoubling, 3.207889560370}, {kFold, 3.208182485077}}},
      {"gap = 0.25\nrestitution = 0.6",
       "gap = 0.1\npenalty = 5.0",  // reached first
       {{kFold, 2.101164634869},
        {kDoubling, 2.183903879624},
        {kDoubling, 3.124978440485},
        {kDoubling, 2.565434188011}}},
      {kRigid,
       "side = \"below\"\ngap = 0.5\nrestitution = 0.3",
       {{kFold, 3.842444753414}, {kDoubling, 3.408881962426}, {kFold, 3.408963286472}}}};
  for (const Located& scene : all) {
    const OrbitDiagram diagram = diagram_of(between(scene.above, scene.below), 1.8, 4.4);
    for (const auto& [kind, value] : scene.points)
      EXPECT_NEAR(nearest(diagram, kind, value), value, kLocated) << describe(kind);
    EXPECT_TRUE(std::ranges::none_of(diagram.branches, [](const OrbitBranch& branch) {
      return branch.ended.find("fails") != std::string::npos;
    }));
  }
}

// Points of the curves polished alone are the same orbits with the same multipliers.
TEST(MixedLawCurves, ConsistOfOrbits) {
  for (const char* other : {"penalty = 20.0", "penalty = 20.0\ndamper = 2.0"}) {
    const ParametrisedScene scene =
        over_frequency(between(kRigid, "side = \"below\"\ngap = 0.5\n" + std::string(other)), 1.8, 4.0);
    const OrbitDiagram diagram = diagram_of(scene.at(2.0), 1.8, 4.0);
    int compared = 0;
    for (const OrbitBranch& branch : diagram.branches) {
      for (std::size_t i = 2; i + 2 < branch.points.size(); i += 5) {
        const ExactOrbit orbit = polished(scene, branch, i);
        if (orbit.outcome != OrbitOutcome::converged) continue;  // next to a grazing
        const double largest = largest_magnitude(orbit.multipliers.values);
        EXPECT_NEAR(largest_magnitude(branch.points[i].multipliers), largest, 1e-5 * std::max(1.0, largest));
        const FlowState &own = branch.orbits[i].start, &alone = orbit.trajectory->orbit().start;
        EXPECT_NEAR(own.state.u[0], alone.state.u[0], 1e-10);
        EXPECT_NEAR(own.state.v[0], alone.state.v[0], 1e-10);
        ++compared;
      }
    }
    EXPECT_GT(compared, 25) << other;
  }
}

// A spring ever stiffer is a rigid stop of restitution 1, as the root of its softness.
TEST(MixedLawCurves, OfStiffSpringsTendToThoseOfRigidStops) {
  const auto doubling = [&](const std::string& law) {
    const Problem problem = between("gap = 0.2\nrestitution = 1.0", "side = \"below\"\ngap = 0.5\n" + law);
    return nearest(diagram_of(problem, 1.8, 4.4, {.max_order = 1}), SpecialKind::period_doubling, 3.15);
  };
  const double limit = doubling("restitution = 1.0");
  double before = 0.0;
  for (const double stiffness : {1e3, 1e4, 1e5}) {
    const double apart = limit - doubling("penalty = " + std::to_string(stiffness));
    if (before > 0.0) {
      EXPECT_NEAR(apart / before, std::sqrt(0.1), 0.01) << stiffness;
    }
    before = apart;
  }
  EXPECT_LT(before, 0.02);
}

// At the impact of one mass on its rigid stop a spring that feels both masses lets go of its contact: as its
// gap shrinks, the maximum of x_1 there, a corner, reaches it, and a phase of contact begins on both sides of
// the impact. The curve goes on with the same orbit and, the force having no jump, the same multipliers.
TEST(MixedLawCurves, PassWhereASpringIsReachedAtAnImpact) {
  const Problem problem = parse_scene(
      "schema = 1\nname = \"s\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.0]\ndampers = [0.2, "
      "0.2]\nsprings = "
      "[1.0, 1.0]\n[forcing]\nfrequency = 1.9\n[[forcing.term]]\ndof = 1\ncos = 1.0\n[[contact]]\ndof = "
      "1\ngap = "
      "0.2\nrestitution = 0.7\n[[contact]]\nnormal = [[0, 1.0], [1, 1.0]]\ngap = 0.5\npenalty = 20.0\n",
      "s.toml");
  const ParametrisedScene scene{.parameter = "gap", .from = 1.0, .to = 0.34, .at = [problem](double gap) {
                                  Problem moved = problem;
                                  moved.contacts[1].gap = gap;
                                  return moved;
                                }};
  OrbitFamily family(scene);
  std::vector<SequencedOrbit> seeds;
  for (SequencedOrbit& orbit : one_impact_orbits(family, 1.0, 0, 2)) seeds.push_back(std::move(orbit));
  const OrbitDiagram diagram = trace_diagram(family, seeds, {});
  const auto with = [&](const std::string& sequence) {
    return std::ranges::find_if(diagram.branches,
                                [&](const OrbitBranch& branch) { return branch.sequence == sequence; });
  };
  const auto clear = with("order 2, events I0"), around = with("order 2, events C1 I0 O1");
  ASSERT_TRUE(clear != diagram.branches.end() && around != diagram.branches.end());
  const double reached = nearest(*clear, SpecialKind::contact_change, 0.459);
  EXPECT_NEAR(reached, 0.459383225855, kLocated);
  for (const SolutionPoint& point : clear->points)
    EXPECT_NEAR(point.x_max[1], reached, kLocated);  // of any gap
  const SolutionPoint& first = around->points.front();
  EXPECT_NEAR(first.parameter, reached, kLocated);
  EXPECT_NEAR(largest_magnitude(first.multipliers), largest_magnitude(clear->points[3].multipliers), 1e-7);
  for (std::size_t i = 2; i < around->points.size(); i += 5) {
    const ExactOrbit orbit = polished(scene, *around, i);
    ASSERT_EQ(orbit.outcome, OrbitOutcome::converged) << orbit.reason;
    EXPECT_NEAR(largest_magnitude(orbit.multipliers.values), largest_magnitude(around->points[i].multipliers),
                1e-7);
  }
}

}  // namespace
}  // namespace signorini::mixed_law_curves_test
