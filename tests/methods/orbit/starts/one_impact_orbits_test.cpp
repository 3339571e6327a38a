// Orbits of one impact against their closed form, and the branches that only they lead to.

#include "methods/orbit/starts/one_impact_orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::one_impact_orbits_test {
namespace {

using test::branch_of;
using test::kLocated;
using test::nearest;

// Those of the closed form that are admissible are found, at every order.
TEST(OneImpactOrbits, AreThoseOfTheClosedForm) {
  int compared = 0;
  for (const double restitution : {1.0, 0.6}) {
    for (int order = 1; order <= 3; ++order) {
      for (const double frequency : {1.7, 2.1, 2.6, 3.3, 4.1}) {
        const test::ImpactOscillator oscillator{
            .damping = 0.1, .frequency = frequency, .gap = 0.2, .restitution = restitution, .order = order};
        OrbitFamily family(over_frequency(test::to_problem(oscillator), 1.5, 4.5));
        const std::vector<SequencedOrbit> found = one_impact_orbits(family, frequency, 0, order);
        EXPECT_LE(found.size(), 2U);
        for (const SequencedOrbit& orbit : found) {
          ExtendedEquations equations(family, orbit);
          ASSERT_TRUE(equations.evaluate(orbit.x));
          EXPECT_LT(equations.residual().lpNorm<Eigen::Infinity>(), 1e-11);
        }
        for (const test::SingleImpactOrbit& exact : test::single_impact_orbits(oscillator)) {
          double distance = 1e300;
          for (const SequencedOrbit& orbit : found) {
            const double phase = std::fmod(orbit.section + orbit.phase(0), 2.0 * std::numbers::pi);
            const double truth = std::fmod(frequency * exact.impact_time, 2.0 * std::numbers::pi);
            distance = std::min(distance, std::abs(std::remainder(phase - truth, 2.0 * std::numbers::pi)));
          }
          EXPECT_LT(distance, 1e-10) << order << " at " << frequency;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 10);
}

// Over the restitution instead of the frequency: impulses of the closed form at every e.
TEST(OneImpactOrbits, LeadThroughTheLawOfImpact) {
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2};
  OrbitFamily family({.parameter = "law.restitution", .from = 1.0, .to = 0.3, .at = [&](double e) {
                        test::ImpactOscillator changed = oscillator;
                        changed.restitution = e;
                        return test::to_problem(changed);
                      }});
  const OrbitDiagram diagram = trace_diagram(family, one_impact_orbits(family, 1.0, 0, 1), {});
  ASSERT_EQ(diagram.branches.size(), 1U);
  EXPECT_NEAR(diagram.branches[0].points.back().parameter + diagram.branches[0].points.front().parameter, 1.3,
              1e-12);
  for (std::size_t i = 0; i < diagram.branches[0].points.size(); ++i) {
    const SolutionPoint& point = diagram.branches[0].points[i];
    const OrbitGuess& orbit = diagram.branches[0].orbits[i];
    test::ImpactOscillator changed = oscillator;
    changed.restitution = point.parameter;
    EXPECT_NEAR(orbit.events.at(0).restitution.at(0), point.parameter, 1e-15);
    const double v0 = orbit.start.state.v[0];
    double distance = 1.0;
    for (const test::SingleImpactOrbit& exact : test::single_impact_orbits(changed))
      distance = std::min(distance, std::abs(exact.velocity(orbit.start.time) - v0));
    EXPECT_LT(distance, 1e-9) << point.parameter;
  }
}

// An isolated branch: one impact in three periods, whose ends graze, found by an orbit of one impact.
TEST(OneImpactOrbits, LeadToIsolatedBranches) {
  OrbitFamily family(
      over_frequency(test::to_problem({.damping = 0.1, .gap = 0.2, .restitution = 0.8}), 1.6, 8.0));
  const OrbitDiagram diagram = trace_diagram(family, one_impact_orbits(family, 4.0, 0, 3), {.max_order = 3});
  const OrbitBranch* three = branch_of(diagram, 3, 1);
  ASSERT_TRUE(three);
  EXPECT_NEAR(nearest(*three, SpecialKind::fold, 5.27), 5.276178, 1e-6);
  EXPECT_NEAR(nearest(*three, SpecialKind::grazing, 3.10), 3.102486, 1e-6);
  EXPECT_NEAR(nearest(*three, SpecialKind::grazing, 3.62), 3.621332, 1e-6);
  EXPECT_TRUE(branch_of(diagram, 3, 2));  // closes it
}

// An isolated branch without ends, once around: the closed form has two orbits between its folds, none
// beyond.
TEST(OneImpactOrbits, LeadOnceAroundAClosedBranch) {
  test::ImpactOscillator oscillator{.damping = 0.1, .gap = 0.6, .restitution = 0.5, .order = 2};
  OrbitFamily family(over_frequency(test::to_problem(oscillator), 0.7, 3.0));
  const OrbitDiagram diagram = trace_diagram(family, one_impact_orbits(family, 2.2, 0, 2), {});
  ASSERT_EQ(diagram.branches.size(), 1U);
  const OrbitBranch& loop = diagram.branches[0];
  EXPECT_EQ(loop.ended, "the branch closes");
  EXPECT_EQ(loop.points.front().parameter, loop.points.back().parameter);
  EXPECT_EQ(std::count_if(loop.special.begin(), loop.special.end(),
                          [](const SpecialPoint& at) { return at.kind == SpecialKind::fold; }),
            2);
  for (const double outwards : {1.0, -1.0}) {
    const double fold = nearest(loop, SpecialKind::fold, outwards > 0.0 ? 2.8 : 2.1);
    oscillator.frequency = fold + 1e-6 * outwards;
    EXPECT_TRUE(test::single_impact_orbits(oscillator).empty()) << fold;
    oscillator.frequency = fold - 1e-6 * outwards;
    EXPECT_EQ(test::single_impact_orbits(oscillator).size(), 2U) << fold;
  }
}

// Free motions of two masses against a stop: with one impact in each period T their impulse is -g / S(T),
// S = sum_r phi_r^2 cot(w_r T / 2) / (2 w_r), and their energy J^2 / 8 sum_r phi_r^2 / sin^2(w_r T / 2).
TEST(OneImpactOrbits, LeadToNonsmoothModes) {
  Problem chain = test::stopped_chain(2, 1.0);
  chain.edit_structure([](Structure& structure) {
    structure.mass = test::symmetric(1.0, 0.0, 1.0);
    structure.damping = SparseMatrix(2, 2);
    structure.stiffness = test::symmetric(2.0, -1.0, 1.0);
  });
  chain.force.clear();
  chain.contacts = {{.normal = {{1, 1.0}}, .gap = 1.0}};
  chain.set_law(Restitution{1.0});
  OrbitFamily family(over_frequency(chain, 0.62, 1.15));
  ASSERT_FALSE(family.driven());
  std::vector<SequencedOrbit> seeds;
  for (const double omega : {0.7, 0.9}) {
    for (SequencedOrbit& orbit : one_impact_orbits(family, omega, 0, 1)) seeds.push_back(std::move(orbit));
  }
  const OrbitDiagram diagram = trace_diagram(family, seeds, {.max_order = 1});
  std::vector<double> doublings, turns;
  int compared = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    if (branch.sequence != "order 1, events I0") continue;
    for (const SpecialPoint& special : branch.special) {
      if (special.kind == SpecialKind::period_doubling) doublings.push_back(special.point.parameter);
      if (special.kind == SpecialKind::fold) turns.push_back(special.point.parameter);
    }
    for (const SolutionPoint& point : branch.points) {
      if (point.energy.value() > 100.0) continue;  // towards a linear mode it is unbounded
      const double T = 2.0 * std::numbers::pi / point.parameter;
      double S = 0.0, spread = 0.0;
      for (const double square : {0.5 * (3.0 - std::sqrt(5.0)), 0.5 * (3.0 + std::sqrt(5.0))}) {
        const double w = std::sqrt(square), share = (2.0 - square) * (2.0 - square);
        const double phi = share / (1.0 + share), half = 0.5 * w * T;
        S += phi / (2.0 * w * std::tan(half));
        spread += phi / (std::sin(half) * std::sin(half));
      }
      EXPECT_NEAR(*point.energy, spread / (8.0 * S * S), 1e-9 * *point.energy) << point.parameter;
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
  std::sort(doublings.begin(), doublings.end());
  std::sort(turns.begin(), turns.end());
  const std::vector<double> lost{2.0 / 3.0, 0.6848714245, std::sqrt(5.0) / 3.0, 1.0860968416,
                                 0.5 * std::sqrt(5.0)};
  ASSERT_EQ(doublings.size(), lost.size());
  for (std::size_t i = 0; i < lost.size(); ++i) EXPECT_NEAR(doublings[i], lost[i], kLocated);
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_NEAR(turns[0], 0.6230095765, kLocated);
  EXPECT_NEAR(turns[1], 0.8714629669, kLocated);
}

// One bounce per period of a ball on a table, A = 0.05 m: with s = pi (1 - e) / (1 + e) its phase is asin of
// s g / (A w^2). It is born at A w^2 = s g, and doubles where
// (A w^2)^2 = g^2 (s^2 + (2 (1 + e^2) / (1 + e)^2)^2).
TEST(OneImpactOrbits, OfABallAreBornAndDoubleWhereTheClosedFormSays) {
  constexpr double kGravity = 9.81, kAmplitude = 0.05, e = 0.8;
  const double s = std::numbers::pi * (1.0 - e) / (1.0 + e);
  const double birth = std::sqrt(s * kGravity / kAmplitude);
  const double doubling =
      std::sqrt(kGravity / kAmplitude * std::hypot(s, 2.0 * (1.0 + e * e) / ((1.0 + e) * (1.0 + e))));
  OrbitFamily family(over_frequency(test::bouncing_ball(), 8.0, 15.0));
  const OrbitDiagram diagram = trace_diagram(family, one_impact_orbits(family, 14.0, 0, 1), {.max_order = 1});
  EXPECT_NEAR(nearest(diagram, SpecialKind::fold, birth), birth, kLocated);
  EXPECT_NEAR(nearest(diagram, SpecialKind::period_doubling, doubling), doubling, kLocated);
}

}  // namespace
}  // namespace signorini::one_impact_orbits_test
