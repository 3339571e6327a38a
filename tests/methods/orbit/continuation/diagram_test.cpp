// Branches of impacting orbits against closed forms: their special points, every orbit on them, and their
// ends.

#include "methods/orbit/continuation/diagram.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/methods/orbit/impulsive_oracle.hpp"
#include "tests/methods/orbit/symmetric_scenes.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::diagram_test {
namespace {

using test::branch_of;
using test::diagram_of;
using test::kLocated;
using test::nearest;
using test::polished;

// Bifurcations of the closed form of one impact in n periods, found there by a scan and bisection.
struct OscillatorTruth {
  double restitution = 1.0, doubling = 0.0, fold = 0.0, doubling_of_two = 0.0;
};

void PrintTo(const OscillatorTruth& truth, std::ostream* out) { *out << "e = " << truth.restitution; }

class ResponseOfTheImpactOscillator : public testing::TestWithParam<OscillatorTruth> {
 protected:
  [[nodiscard]] test::ImpactOscillator oscillator() const {
    return {.damping = 0.1, .gap = 0.2, .restitution = GetParam().restitution};
  }
};

TEST_P(ResponseOfTheImpactOscillator, MeetsTheSpecialPointsOfItsClosedForm) {
  const OscillatorTruth& truth = GetParam();
  const OrbitDiagram diagram = diagram_of(test::to_problem(oscillator()), 1.5, 4.5);
  const Branch *free = branch_of(diagram, 1, 0), *one = branch_of(diagram, 1, 1),
               *two = branch_of(diagram, 2, 1);
  ASSERT_TRUE(free && one && two);
  EXPECT_NEAR(nearest(*free, SpecialKind::grazing, 2.448), 2.448265181813, 1e-11);
  EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, 2.26), truth.doubling, kLocated);
  EXPECT_NEAR(nearest(*two, SpecialKind::fold, 3.6), truth.fold, kLocated);
  EXPECT_NEAR(nearest(*two, SpecialKind::period_doubling, 2.9), truth.doubling_of_two, kLocated);
  EXPECT_EQ(diagram.unfinished, "");
  for (const OrbitBranch& branch : diagram.branches)
    EXPECT_FALSE(branch.began.empty() || branch.ended.empty());
}

// Orbits at the ends of branches graze, where a polish refuses them.
TEST_P(ResponseOfTheImpactOscillator, HasPointsThatAreOrbitsOfTheScene) {
  const ParametrisedScene scene = over_frequency(test::to_problem(oscillator()), 1.5, 4.5);
  for (const OrbitBranch& branch : diagram_of(scene.at(2.0), scene.from, scene.to).branches) {
    for (std::size_t i = 1; i + 1 < branch.points.size(); ++i) {
      const SolutionPoint& point = branch.points[i];
      const ExactOrbit orbit = polished(scene, branch, i);
      ASSERT_EQ(orbit.outcome, OrbitOutcome::converged) << point.parameter << " " << orbit.reason;
      EXPECT_LE(orbit.iterations, 2) << point.parameter;
      EXPECT_EQ(point.stability == OrbitStability::stable, largest_magnitude(orbit.multipliers.values) < 1.0)
          << point.parameter;
      if (point.impacts != 1) continue;
      test::ImpactOscillator closed = oscillator();
      closed.frequency = point.parameter;
      closed.order = point.order;
      double distance = 1.0;
      for (const test::SingleImpactOrbit& exact : test::single_impact_orbits(closed))
        distance = std::min(distance, std::abs(exact.impulse + orbit.trajectory->impulses().at(0).value));
      EXPECT_LT(distance, 1e-9) << point.parameter;
    }
  }
}

// Neighbours are so as motions, at every phase of the load; an impact moves by a phase, and with it the
// displacement by no more than speed times that.
TEST_P(ResponseOfTheImpactOscillator, NowhereJumps) {
  constexpr double kMost = 4.0;  // times as far as the longest step
  const double longest = kOrbitSteps.longest;
  const Problem problem = test::to_problem(oscillator());
  OrbitFamily family(over_frequency(problem, 1.5, 4.5));
  const CurveUnits& units = family.units();
  for (const OrbitBranch& branch : diagram_of(problem, 1.5, 4.5, {.phases = 64}).branches) {
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const SolutionPoint &a = branch.points[i - 1], &b = branch.points[i];
      EXPECT_LE(std::abs(b.parameter - a.parameter), 1.01 * longest * units.parameter);
      ASSERT_EQ(a.motion.rows(), b.motion.rows());
      EXPECT_LE((b.motion - a.motion).cwiseAbs().maxCoeff(), kMost * longest * units.displacement)
          << branch.sequence << " at " << a.parameter << " and " << b.parameter;
      EXPECT_GE(b.parameter, 1.5 - 1e-12);
      EXPECT_LE(b.parameter, 4.5 + 1e-12);
      EXPECT_LE(b.x_max.at(0), 0.2 + 1e-11);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, ResponseOfTheImpactOscillator,
                         testing::Values(OscillatorTruth{1.0, 2.2647019400, 3.8553753210, 2.9125835787},
                                         OscillatorTruth{0.8, 2.2652971760, 3.6934249832, 2.8875236601},
                                         OscillatorTruth{0.5, 2.2646455610, 3.4543608376, 2.8104370993}));

// Whatever the steps: located points do not depend on them.
TEST(TraceDiagram, LocatesTheSamePointsWithOtherSteps) {
  const Problem problem = test::to_problem({.damping = 0.1, .gap = 0.2, .restitution = 0.8});
  for (const double step : {0.03, 0.4}) {
    const OrbitDiagram diagram = diagram_of(problem, 1.5, 4.5, {.step_share = step / kOrbitSteps.longest});
    const OrbitBranch* two = branch_of(diagram, 2, 1);
    ASSERT_TRUE(two);
    EXPECT_NEAR(nearest(*two, SpecialKind::fold, 3.6), 3.6934249832, kLocated) << step;
    EXPECT_NEAR(nearest(*two, SpecialKind::period_doubling, 2.9), 2.8875236601, kLocated) << step;
    EXPECT_EQ(diagram.branches.size(), 4U) << step;
  }
}

// The doubled orbits that leave (1, 1) end at the grazing at which those of (1, 2) take a second impact.
TEST(TraceDiagram, FindsTheDoubledOrbitsOnceAndClosesTheGraph) {
  const OrbitDiagram diagram = diagram_of(test::to_problem({.damping = 0.1, .gap = 0.2}), 1.5, 4.5);
  ASSERT_EQ(diagram.branches.size(), 4U);
  const Branch *two = branch_of(diagram, 2, 1), *doubled = branch_of(diagram, 2, 2);
  ASSERT_TRUE(two && doubled);
  EXPECT_NEAR(nearest(*two, SpecialKind::grazing, 2.44), nearest(*doubled, SpecialKind::grazing, 2.44),
              1e-11);
}

// Without loss multipliers stay on the circle: no orbit is stable, and the doubling is a double -1.
TEST(TraceDiagram, TellsMotionsWithoutLossRightly) {
  const OrbitDiagram diagram = diagram_of(test::to_problem({.damping = 0.0, .gap = 0.2}), 1.9, 4.5);
  const OrbitBranch* one = branch_of(diagram, 1, 1);
  ASSERT_TRUE(one);
  EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, 2.26), 2.2661984962, kLocated);
  int elliptic = 0;
  for (const SolutionPoint& point : one->points) {
    EXPECT_NE(point.stability, OrbitStability::stable) << point.parameter;
    if (point.stability != OrbitStability::elliptic) continue;
    ++elliptic;
    EXPECT_NEAR(std::abs(point.multipliers[0]), 1.0, 1e-7);
  }
  EXPECT_GT(elliptic, 5);
}

// From an orbit in the middle of the interval both ways, as one branch.
TEST(TraceDiagram, JoinsTheTwoHalvesOfABranch) {
  OrbitFamily family(over_frequency(test::to_problem({.damping = 0.1, .gap = 0.2}), 2.0, 4.0));
  const OrbitDiagram diagram = trace_diagram(family, {contact_free_orbit(family, 3.0).value()}, {});
  const OrbitBranch* free = branch_of(diagram, 1, 0);
  ASSERT_TRUE(free);
  const auto [least, most] = std::minmax_element(
      free->points.begin(), free->points.end(),
      [](const SolutionPoint& a, const SolutionPoint& b) { return a.parameter < b.parameter; });
  EXPECT_NEAR(least->parameter, 2.448265181813, 1e-11);
  EXPECT_NEAR(most->parameter, 4.0, 1e-12);
  for (const SpecialPoint& special : free->special) EXPECT_LE(special.after, free->points.size());
}

// A motion between two stops at equal distance reaches both at once, and strikes both beyond.
TEST(TraceDiagram, FollowsImpactsOnBothStopsFromASymmetricGrazing) {
  Problem problem = test::to_problem({.damping = 0.1, .gap = 0.2, .restitution = 0.8});
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.2, .law = problem.contacts.front().law});
  const ParametrisedScene scene = over_frequency(problem, 1.5, 4.5);
  const OrbitDiagram diagram = diagram_of(problem, 1.5, 4.5);
  const OrbitBranch* both = branch_of(diagram, 1, 2);
  ASSERT_TRUE(both);
  EXPECT_GT(both->points.size(), 10U);
  for (std::size_t i = 1; i + 1 < both->points.size(); ++i) {
    const ExactOrbit orbit = polished(scene, *both, i);
    ASSERT_EQ(orbit.outcome, OrbitOutcome::converged) << both->points[i].parameter << " " << orbit.reason;
    const auto& impulses = orbit.trajectory->impulses();
    ASSERT_EQ(impulses.size(), 2U);
    EXPECT_NEAR(impulses[0].value, impulses[1].value, 1e-9);
    EXPECT_NEAR(std::abs(impulses[1].time - impulses[0].time), 0.5 * orbit.trajectory->period(), 1e-9);
  }
}

// What leads on into the rest of the interval comes before all else, and makes a search there needless.
TEST(TraceDiagram, HoldsTheIntervalFirst) {
  OrbitFamily family(over_frequency(test::to_problem({.damping = 0.1, .gap = 0.2}), 1.5, 4.5));
  const std::vector<SequencedOrbit> free = {contact_free_orbit(family, 4.5).value()};
  int searches = 0;
  const auto in_vain = [&](double) {
    ++searches;
    return std::vector<SequencedOrbit>{};
  };
  const OrbitDiagram diagram = trace_diagram(family, free, {.max_branches = 2}, in_vain);
  std::vector<ParameterRange> held;
  for (const OrbitBranch& branch : diagram.branches) held.push_back(range_of(branch));
  EXPECT_TRUE(uncovered(held, 1.5, 4.5).empty());
  EXPECT_EQ(searches, 0);
}

// Below the grazing no branch is followed here: searches end once they find nothing.
TEST(TraceDiagram, SearchesWhatNothingLeadsIntoAFewTimesOnly) {
  OrbitFamily family(over_frequency(test::to_problem({.damping = 0.1, .gap = 0.2}), 0.5, 2.0));
  std::vector<double> asked;
  const auto in_vain = [&](double value) {
    asked.push_back(value);
    return std::vector<SequencedOrbit>{};
  };
  const OrbitDiagram diagram = trace_diagram(family, {}, {}, in_vain);
  EXPECT_TRUE(diagram.branches.empty());
  EXPECT_EQ(asked.size(), 4U);
  for (const double value : asked) EXPECT_TRUE(value > 0.5 && value < 2.0);
}

TEST(TraceDiagram, StopsAtItsLimitsAndSaysSo) {
  const Problem problem = test::to_problem({.damping = 0.1, .gap = 0.2});
  const OrbitDiagram few = diagram_of(problem, 1.5, 4.5, {.max_branches = 2});
  EXPECT_EQ(few.branches.size(), 2U);
  EXPECT_NE(few.unfinished.find("limit of 2"), std::string::npos) << few.unfinished;
  const OrbitDiagram brief = diagram_of(problem, 1.5, 4.5, {.max_points = 5});
  EXPECT_EQ(brief.branches.at(0).ended, "limit of 5 points");
  const OrbitDiagram late = diagram_of(problem, 1.5, 4.5, {.stopped = [] { return true; }});
  EXPECT_TRUE(late.branches.empty());
}

TEST(TraceDiagram, FollowsOneImpactOfAChainAsItsClosedForm) {
  constexpr double kRestitution = 0.8;
  const Problem problem = test::stopped_chain(2, kRestitution);
  const ParametrisedScene scene = over_frequency(problem, 0.5, 3.0);
  const OrbitDiagram diagram = diagram_of(problem, scene.from, scene.to, {.max_branches = 12});
  int compared = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    for (std::size_t i = 1; i + 1 < branch.points.size(); ++i) {
      const SolutionPoint& point = branch.points[i];
      const ExactOrbit orbit = polished(scene, branch, i);
      ASSERT_EQ(orbit.outcome, OrbitOutcome::converged) << point.parameter << " " << orbit.reason;
      if (point.impacts != 1) continue;
      const double mass = 1.0 / delassus_matrix(problem)(0, 0);
      const double v = -orbit.trajectory->impulses().at(0).value / ((1.0 + kRestitution) * mass);
      double distance = 1.0;
      const Problem at = with_subharmonic(scene.at(point.parameter), point.order);
      for (const double speed : test::ImpulsiveOracle(at, kRestitution).speeds)
        distance = std::min(distance, std::abs(speed - v));
      EXPECT_LT(distance, 1e-10 * std::max(1.0, v)) << branch.sequence << " at " << point.parameter;
      ++compared;
    }
  }
  EXPECT_GT(compared, 50);
}

ExactOrbit orbit_from_rest(const Problem& problem) {
  OrbitFinder finder(problem);
  const std::vector<bool> open(static_cast<std::size_t>(problem.contact_count()), false);
  const FlowState rest{.time = 0.0, .state = finder.model()->dynamics.at_rest(), .closed = open};
  const SearchOptions options{.followed = 400, .shootings = 0, .expired = [] { return false; }};
  return finder.find(OrbitGuess{.start = rest, .events = {}, .origin = "rest"}, options).orbit;
}

// The orbit of a scene that a march from rest leads to, as a start.
SequencedOrbit marched(OrbitFamily& family, double parameter) {
  const Problem problem = family.scene().at(parameter);
  const ExactOrbit orbit = orbit_from_rest(problem);
  EXPECT_TRUE(orbit.certified()) << orbit.reason;
  return sequenced(family, orbit.trajectory->orbit(), problem.period(), problem.frequency, parameter);
}

bool strikes_together(const SolutionPoint& point) {
  return std::abs(point.amplitude[0] - point.amplitude[1]) < 1e-9 && point.impacts == 2 * point.order;
}

// Symmetric motions are one branch, whose multipliers are those of an independent flow; what leaves it, at
// 2.0975915 where one of them is 1, comes in mirrored pairs.
TEST(TraceDiagram, FollowsTwinsOnceAndLeavesThemInEitherOrder) {
  OrbitFamily family(over_frequency(test::twins({.spring = 0.5, .damper = 0.05}), 1.9, 2.6));
  const OrbitDiagram diagram =
      trace_diagram(family, {marched(family, 2.2)}, {.max_order = 1, .at = {2.0, 2.2, 2.4}});
  int symmetric = 0, crossing = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    if (branch.began.starts_with("branch point at 2.0975915")) ++crossing;
    if (!strikes_together(branch.points[branch.points.size() / 2])) continue;
    ++symmetric;
    EXPECT_EQ(branch.orbits.front().events.size(), 2U);
    EXPECT_NEAR(nearest(branch, SpecialKind::branch_point, 2.0975915), 2.097591537, 1e-7);
    for (const SolutionPoint& point : branch.points) {
      EXPECT_NE(point.stability, OrbitStability::stable) << point.parameter;
      if (point.parameter < 2.0975915) {
        EXPECT_EQ(point.stability, OrbitStability::undefined) << point.parameter;
        EXPECT_TRUE(point.undefined.starts_with(kDependsOnOrder)) << point.undefined;
      }
      if (point.parameter == 2.2) {
        EXPECT_EQ(point.stability, OrbitStability::unstable);
        EXPECT_NEAR(point.multipliers.cwiseAbs().maxCoeff(), 2.593212, 1e-5);
      }
    }
  }
  EXPECT_EQ(symmetric, 1);
  EXPECT_EQ(crossing, 2);
}

TEST(TraceDiagram, FollowsTwinsThatDoNotFeelEachOtherAsOne) {
  OrbitFamily family(over_frequency(test::twins({.spring = 0.3}), 1.9, 2.6));
  const OrbitDiagram diagram = trace_diagram(family, {marched(family, 2.2)}, {.max_order = 1});
  const auto together = std::ranges::count_if(diagram.branches, [](const OrbitBranch& branch) {
    return strikes_together(branch.points[branch.points.size() / 2]);
  });
  EXPECT_EQ(together, 1);
  for (const OrbitBranch& branch : diagram.branches) {
    for (const SolutionPoint& point : branch.points) EXPECT_EQ(point.undefined, "");
  }
}

TEST(TraceDiagram, HasNoMultipliersWhereTheMassCouplesWhatStrikesTogether) {
  OrbitFamily family(over_frequency(test::bar(0.4, 0.4, 0.1, 0.8), 2.0, 2.3));
  const OrbitDiagram diagram = trace_diagram(family, {marched(family, 2.2)}, {.max_order = 2});
  ASSERT_EQ(diagram.branches.size(), 1U);
  for (const SolutionPoint& point : diagram.branches[0].points) {
    EXPECT_EQ(point.stability, OrbitStability::undefined);
    EXPECT_EQ(point.undefined, kDependsOnOrder);
    EXPECT_EQ(point.multipliers.size(), 0);
  }
}

// The gap of one of two oscillators passes that of the other: their impacts come together and part again.
TEST(TraceDiagram, PassesImpactsThatComeTogetherUnlessTheyFeelEachOther) {
  struct Meeting {
    test::Twins twins;
    std::string ends;
  };
  for (const Meeting& meeting :
       {Meeting{{.spring = 0.3}, "coincide"},
        Meeting{{.spring = 0.3, .damper = 0.02, .frequency = 2.0}, "a corner, for the derivative"}}) {
    const ParametrisedScene scene{
        .parameter = "contact[0].gap", .from = 0.19, .to = 0.21, .at = [&](double gap) {
          Problem problem = test::twins(meeting.twins);
          problem.contacts[0].gap = gap;
          return problem;
        }};
    OrbitFamily family(scene);
    // The orbit with both gaps .2, and from its sequence the one where the first is .199.
    const Problem problem = scene.at(0.199);
    const OrbitGuess symmetric = orbit_from_rest(scene.at(0.2)).trajectory->orbit();
    const ExactOrbit apart = polish_sequence(std::make_shared<OrbitModel>(problem), symmetric);
    ASSERT_TRUE(apart.certified()) << apart.reason;
    const SequencedOrbit start =
        sequenced(family, apart.trajectory->orbit(), problem.period(), problem.frequency, 0.199);
    const OrbitDiagram diagram = trace_diagram(family, {start}, {.max_order = 1});
    bool met = false, passed = false;
    for (const OrbitBranch& branch : diagram.branches) {
      if (branch.points[1].impacts != 2) continue;
      for (const auto& [end, why] : {std::pair(branch.points.front().parameter, branch.began),
                                     std::pair(branch.points.back().parameter, branch.ended)}) {
        met |= std::abs(end - 0.2) < 1e-9 && why.find(meeting.ends) != std::string::npos;
        passed |= end > 0.2099;
      }
    }
    EXPECT_TRUE(met) << meeting.ends;
    EXPECT_TRUE(passed) << meeting.ends;
  }
}

}  // namespace
}  // namespace signorini::diagram_test
