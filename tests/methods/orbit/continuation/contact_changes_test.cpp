// Spring stops and sticking: phases of contact that begin and end, against curves located before.

#include "methods/orbit/continuation/contact_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::contact_changes_test {
namespace {

using test::branch_of;
using test::diagram_of;
using test::kLocated;
using test::nearest;
using test::polished;

// The spring stops of curves whose folds and doublings were located before, by another program.
struct SpringTruth {
  double stiffness = 1.0, doubling = 0.0, fold = 0.0;
};

TEST(PastChange, MeetsTheSpecialPointsOfSpringStops) {
  for (const SpringTruth& truth :
       {SpringTruth{1e2, 2.2062846538, 3.5167116923}, SpringTruth{1e3, 2.2446234624, 3.7417813298},
        SpringTruth{1e4, 2.2581813092, 3.8188010302}}) {
    const ParametrisedScene scene = over_frequency(test::penalty_oscillator(truth.stiffness), 1.5, 4.5);
    const OrbitDiagram diagram = diagram_of(scene.at(2.0), 1.5, 4.5);
    const OrbitBranch *one = branch_of(diagram, 1, 1), *two = branch_of(diagram, 2, 1);
    ASSERT_TRUE(one && two) << truth.stiffness;
    EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, truth.doubling), truth.doubling, kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::fold, truth.fold), truth.fold, kLocated);
    EXPECT_EQ(one->special.front().kind, SpecialKind::period_doubling);  // no fold where contact begins
    for (std::size_t i = 1; i < one->points.size(); ++i) {
      const SolutionPoint& point = one->points[i];
      const ExactOrbit orbit = polished(scene, *one, i);
      // A phase of contact of next to no length is refused by the polish.
      if (orbit.outcome != OrbitOutcome::converged) continue;
      EXPECT_EQ(point.stability == OrbitStability::stable, largest_magnitude(orbit.multipliers.values) < 1.0)
          << point.parameter;
    }
  }
}

// Example 03 of NLvib: contact-free, in contact over a fold 6e-9 beside where it begins, contact-free again.
TEST(PastChange, PassesTheTwoMassesOfNlvib) {
  Problem chain = test::stopped_chain(2, 1.0);
  chain.edit_structure([](Structure& structure) {
    structure.mass = test::symmetric(1.0, 0.0, 1.0);
    structure.damping = test::symmetric(0.06, -0.03, 0.03);
    structure.stiffness = test::symmetric(2.0, -1.0, 1.0);
  });
  chain.force = {{.dof = 0, .harmonic = 1, .cos = 0.1}};
  chain.contacts = {{.normal = {{1, 1.0}}, .gap = 1.0}};
  chain.set_law(Penalty{{100.0}});
  constexpr double kPrinted = 2e-12;
  for (const auto& [from, to] : {std::pair(0.5, 2.5), std::pair(2.5, 0.5)}) {  // from either end
    const OrbitDiagram diagram = diagram_of(chain, from, to, {.max_order = 1});
    EXPECT_NEAR(nearest(diagram, SpecialKind::fold, 0.7556), 0.7556273526, 1e-10);
    EXPECT_NEAR(nearest(diagram, SpecialKind::period_doubling, 0.7387), 0.7387830254, 1e-10);
    EXPECT_NEAR(nearest(diagram, SpecialKind::period_doubling, 0.7556), 0.7555861594, 1e-10);
    EXPECT_NEAR(nearest(diagram, SpecialKind::neimark_sacker, 0.6186), 0.6186068742670, kPrinted);
    EXPECT_NEAR(nearest(diagram, SpecialKind::neimark_sacker, 0.5819), 0.5819006504, 1e-10);
    EXPECT_NEAR(nearest(diagram, SpecialKind::contact_change, 0.5819), 0.581899639039, kPrinted);
    EXPECT_NEAR(nearest(diagram, SpecialKind::contact_change, 0.6534), 0.653440140416, kPrinted);
    const OrbitBranch* one = branch_of(diagram, 1, 1);
    ASSERT_TRUE(one);
    const auto folds = std::count_if(one->special.begin(), one->special.end(),
                                     [](const auto& special) { return special.kind == SpecialKind::fold; });
    EXPECT_EQ(folds, 2) << from;
    EXPECT_EQ(diagram.branches.size(), 3U) << from;
  }
}

// Three massless contacts on a beam. Among the first changes after the contact-free motion are interruptions
// of contact that fade, and two events that exchange their order.
TEST(PastChange, LeadsThroughTheChangesOfThreeContacts) {
  constexpr int kBranches = 18;
  const OrbitDiagram diagram = diagram_of(load_scene(find_scene("beam20-three-stops")), 4.0, 5.5,
                                          {.max_order = 1, .max_branches = kBranches});
  EXPECT_TRUE(diagram.notes.empty()) << diagram.notes.front();
  ASSERT_EQ(diagram.branches.size(), static_cast<std::size_t>(kBranches));
  int ended_phases = 0, exchanged = 0;
  for (std::size_t i = 0; i + 1 < diagram.branches.size(); ++i) {
    const std::string& ended = diagram.branches[i].ended;
    if (ended.find("tends to zero") != std::string::npos ||
        ended.find("stops pressing") != std::string::npos || ended.find("meet") != std::string::npos)
      ++ended_phases;
    if (ended.find("coincide") != std::string::npos) ++exchanged;
    // The next branch goes on from there.
    EXPECT_NEAR(diagram.branches[i].points.back().parameter, diagram.branches[i + 1].points.front().parameter,
                1e-9)
        << ended;
    EXPECT_NEAR(diagram.branches[i].points.back().amplitude[0],
                diagram.branches[i + 1].points.front().amplitude[0], 1e-9);
  }
  EXPECT_GE(ended_phases, 3);
  EXPECT_EQ(exchanged, 1);
  EXPECT_GT(diagram.branches.back().points.back().parameter, 4.55);
}

// Between 4.4546 and 4.4554 rad/s contact 0 presses once more, for less than a step: the search between its
// points, which comes to no end there, shortens it.
TEST(PastChange, AreTheSameWhateverTheSteps) {
  const ParametrisedScene scene = over_frequency(load_scene(find_scene("beam20-three-stops")), 4.4, 4.5);
  const auto ends = [&](double step) {
    OrbitFamily family(scene);
    const OrbitDiagram diagram =
        trace_diagram(family, {contact_free_orbit(family, 4.5).value()},
                      {.max_order = 1, .max_branches = 8, .step_share = step / kOrbitSteps.longest});
    std::vector<double> parameters;
    for (const OrbitBranch& branch : diagram.branches) parameters.push_back(branch.points.back().parameter);
    return parameters;
  };
  const std::vector<double> fine = ends(0.03), coarse = ends(0.15);
  ASSERT_EQ(fine.size(), coarse.size());
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_NEAR(fine[i], coarse[i], 1e-9) << i;
  EXPECT_TRUE(std::any_of(fine.begin(), fine.end(), [](double p) { return p > 4.4546 && p < 4.4554; }));
}

// Where an interruption of contact ends, the closing behind it has no speed. Which of the two guards is met
// first is rounding, and both lead to the same motion.
TEST(PastChange, EndsAnInterruptionWhicheverOfItsGuardsIsMet) {
  OrbitFamily family(over_frequency(load_scene(find_scene("beam20-three-stops")), 4.0, 5.5));
  const auto lower = [](const ExtendedEquations& at) { return -at.parameter(); };
  std::optional<CurveStart> start =
      start_where_grows(family, contact_free_orbit(family, 5.5).value(), lower, "contact-free");
  TracedCurve curve;
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE(start) << k;
    curve = trace_curve(family, *start, {});
    ASSERT_TRUE(curve.guard) << curve.branch.ended;
    start = past_change(family, curve).start;
  }
  const bool ends_interval = curve.guard->kind == GuardKind::interval;
  ASSERT_TRUE(ends_interval || curve.guard->kind == GuardKind::approach) << curve.branch.ended;
  const auto later = static_cast<std::size_t>(curve.guard->index);
  ASSERT_EQ(curve.last.events[later].kind, ContactEvent::Kind::close);  // an interruption
  curve.guard->kind = ends_interval ? GuardKind::approach : GuardKind::interval;
  const ChangeOfSequence change = past_change(family, curve);
  ASSERT_TRUE(change.start) << change.obstacle;
  EXPECT_EQ(change.start->orbit.events.size(), start->orbit.events.size());
  EXPECT_LT((change.start->orbit.x - start->orbit.x).norm(), 1e-12);
  ExtendedEquations equations(family, change.start->orbit);
  ASSERT_TRUE(equations.evaluate(change.start->orbit.x));
  EXPECT_LT(equations.residual().norm(), 1e-9);
}

// A break of contact 0 ends at 4.50326 rad/s, where the frequency turns on a radius of 1e-6 of its unit: no
// step along the curve is as short. In this interval; in a longer one, of coarser units, the break was
// stepped over.
TEST(PastChange, EndsABreakOfContactOnAStiffStopInItsLength) {
  const ParametrisedScene scene = over_frequency(load_scene(find_scene("beam20-three-stops")), 4.4, 4.52);
  OrbitFamily family(scene);
  const OrbitDiagram diagram =
      trace_diagram(family, {contact_free_orbit(family, 4.52).value()}, {.max_branches = 24});
  EXPECT_NEAR(nearest(diagram, SpecialKind::contact_change, 4.5032556595), 4.5032556595, 5e-10);
  for (const OrbitBranch& branch : diagram.branches)
    EXPECT_NE(branch.ended, "the corrector fails") << branch.sequence;
}

// Without restitution the impact turns into a phase of sticking, which ends as the closed form says.
TEST(PastChange, GoesOnWhereAContactBeginsToStick) {
  const Problem problem = test::to_problem({.damping = 0.02, .gap = 0.2, .restitution = 0.0});
  const OrbitDiagram diagram = diagram_of(problem, 1.3, 3.0, {.max_order = 1});
  const OrbitBranch* one = branch_of(diagram, 1, 1);
  ASSERT_TRUE(one);
  EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, 2.246), 2.246134137, 1e-9);
  EXPECT_NEAR(nearest(*one, SpecialKind::contact_change, 1.659), 1.659239862581, 1e-11);
  const auto stick =
      std::find_if(diagram.branches.begin(), diagram.branches.end(),
                   [](const OrbitBranch& branch) { return branch.sequence == "order 1, events C0 O0"; });
  ASSERT_NE(stick, diagram.branches.end());
  EXPECT_NEAR(stick->points.front().parameter, 1.659239862581, 1e-11);
  EXPECT_NEAR(stick->points.back().parameter, 1.3, 1e-12);
  // While it sticks the load pushes: it lets go where F cos(w t) = k g, and the motion forgets all before.
  for (std::size_t i = 1; i < stick->points.size(); ++i) {
    const SolutionPoint& point = stick->points[i];
    const SequenceEvent& open = stick->orbits[i].events.back();
    ASSERT_EQ(open.kind, ContactEvent::Kind::open);
    EXPECT_NEAR(std::cos(point.parameter * open.time), 0.2, 1e-10);
    EXPECT_EQ(point.stability, OrbitStability::stable);
    EXPECT_LT(point.multipliers.cwiseAbs().maxCoeff(), 1e-10);
  }
}

}  // namespace
}  // namespace signorini::contact_changes_test
