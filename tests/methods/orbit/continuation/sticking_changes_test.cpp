// Perfectly plastic stops: grazings of motions that stick, short flights and interruptions, against flights
// from rest in closed form.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/continuation/contact_changes.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::sticking_changes_test {
namespace {

using test::branch_of;
using test::diagram_of;
using test::nearest;
using test::polished;

// A mass m = k = F = 1 on its stop at g, where the load cos(w t) lets it go: cos(w t_0) = g, falling. What
// follows does not depend on what came before.
struct FlightFromRest {
  double damping, gap, frequency;

  [[nodiscard]] double release() const { return std::acos(gap) / frequency; }
  [[nodiscard]] double x(double t) const {
    const std::complex<double> i(0.0, 1.0), z = 1.0 / (1.0 - frequency * frequency + i * damping * frequency);
    const auto forced = [&](double at) { return z * std::exp(i * frequency * at); };
    const double wd = std::sqrt(1.0 - 0.25 * damping * damping), s = t - release(), a = 0.5 * damping;
    const double x0 = gap - forced(release()).real();
    const double v0 = -(i * frequency * forced(release())).real();
    return forced(t).real() +
           std::exp(-a * s) * (x0 * std::cos(wd * s) + (v0 + a * x0) / wd * std::sin(wd * s));
  }
  // The largest x between two shares of a period of the load after the release, by samples and a parabola.
  [[nodiscard]] double highest(double from, double to) const {
    constexpr int kSamples = 20000;
    const double period = 2.0 * std::numbers::pi / frequency, h = (to - from) * period / kSamples;
    double best = -1e300, at = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
      const double t = release() + from * period + k * h;
      if (x(t) > best) {
        best = x(t);
        at = t;
      }
    }
    const double a = x(at - h), c = x(at + h), curvature = a - 2.0 * best + c;
    return best - 0.125 * (c - a) * (c - a) / curvature;
  }
};

// The frequency between two at which a function changes its sign.
template <class Function>
double bisected(double low, double high, const Function& f) {
  const bool sign = f(low) > 0.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == sign ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// At a frequency above, the motion that sticks once in two periods misses the stop in between; below it
// strikes. Both branches end at one grazing, whatever the steps.
TEST(StickingChanges, LocateTheGrazingOfAMotionThatSticksWhateverTheSteps) {
  const double truth = bisected(2.37, 2.42, [](double frequency) {
    return FlightFromRest{.damping = 0.1, .gap = 0.2, .frequency = frequency}.highest(1.2, 1.65) - 0.2;
  });
  const Problem problem = test::to_problem({.damping = 0.1, .gap = 0.2, .restitution = 0.0});
  for (const double step : {0.03, 0.05, 0.15, 0.4}) {
    const OrbitDiagram diagram = diagram_of(problem, 1.5, 4.0, {.step_share = step / kOrbitSteps.longest});
    for (const char* sequence : {"order 2, events C0 O0", "order 2, events I0 C0 O0"}) {
      const auto branch = std::find_if(diagram.branches.begin(), diagram.branches.end(),
                                       [&](const OrbitBranch& b) { return b.sequence == sequence; });
      ASSERT_NE(branch, diagram.branches.end()) << sequence;
      EXPECT_NEAR(nearest(*branch, SpecialKind::grazing, truth), truth, 1e-10) << sequence << " " << step;
    }
    EXPECT_TRUE(diagram.notes.empty()) << diagram.notes.front();
  }
}

// Down from where the contact begins to stick, the closing meets no force at .559371783202 (prototype of
// curves by another program): an impact comes before it from there on, and a flight of no length.
TEST(StickingChanges, BeginAShortFlightWhereAClosingMeetsNoForce) {
  const Problem problem = test::to_problem({.damping = 0.02, .gap = 0.2, .restitution = 0.0});
  const ParametrisedScene scene = over_frequency(problem, 0.5, 3.0);
  const OrbitDiagram diagram = diagram_of(problem, 0.5, 3.0, {.max_order = 1});
  const auto flight =
      std::find_if(diagram.branches.begin(), diagram.branches.end(), [](const OrbitBranch& b) {
        return b.began.find("short flight") != std::string::npos && b.points.front().parameter > 0.5;
      });
  ASSERT_NE(flight, diagram.branches.end());
  EXPECT_NEAR(nearest(diagram, SpecialKind::contact_change, 0.5594), 0.559371783202, 1e-11);
  EXPECT_NEAR(flight->points.front().parameter, 0.559371783202, 1e-11);
  int compared = 0;
  for (std::size_t i = 2; i + 1 < flight->points.size(); ++i) {
    const ExactOrbit orbit = polished(scene, *flight, i);
    if (orbit.outcome == OrbitOutcome::grazing) continue;  // a flight too short for a polish
    ASSERT_EQ(orbit.outcome, OrbitOutcome::converged) << orbit.reason;
    ++compared;
  }
  EXPECT_GT(compared, 3);
}

// Events of the orbit with the second oracle at w = .5: impact, closing and release.
TEST(StickingChanges, ReachTheFlightsOfTheClosedForm) {
  const Problem problem = test::to_problem({.damping = 0.02, .gap = 0.2, .restitution = 0.0});
  const OrbitDiagram diagram = diagram_of(problem, 0.4, 3.0, {.max_order = 1, .at = {0.5}});
  constexpr double kPeriod = 4.0 * std::numbers::pi;
  int found = 0;
  for (const OrbitBranch& branch : diagram.branches) {
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const std::vector<SequenceEvent>& events = branch.orbits[i].events;
      if (std::abs(branch.points[i].parameter - 0.5) > 1e-12 || events.size() != 3) continue;
      ++found;
      for (const SequenceEvent& event : events) {
        const double truth = event.kind == ContactEvent::Kind::impact  ? 9.4661871002
                             : event.kind == ContactEvent::Kind::close ? 10.5184268516
                                                                       : 2.7388768120;
        const double apart = std::remainder(event.time - truth, kPeriod);
        EXPECT_NEAR(apart, 0.0, 2e-10) << static_cast<int>(event.kind);
      }
    }
  }
  EXPECT_EQ(found, 1);
}

// The orbits of a chain from the contact-free motion down to sticking, and up again from one of them: two
// phases of sticking become one where the flight between them ends, and one is interrupted at the same place.
TEST(StickingChanges, LeadAChainThroughInterruptionsBothWays) {
  const ParametrisedScene scene = over_frequency(load_scene(find_scene("chain2-stick")), 0.2, 6.0);
  OrbitFamily family(scene);
  const OrbitDiagram down =
      trace_diagram(family, {contact_free_orbit(family, 6.0).value()}, {.max_order = 1});
  EXPECT_TRUE(down.notes.empty()) << down.notes.front();
  EXPECT_NEAR(down.branches.back().points.back().parameter, 0.2, 2e-15);  // to which `locate` goes
  const OrbitBranch* merged = nullptr;
  for (const OrbitBranch& branch : down.branches) {
    EXPECT_NE(branch.ended, "the corrector fails") << branch.sequence;
    if (branch.began.find("no longer opens") != std::string::npos) merged = &branch;
    for (std::size_t i = 1; i + 1 < branch.points.size(); i += 3) {
      const ExactOrbit orbit = polished(scene, branch, i);
      EXPECT_TRUE(orbit.certified() || orbit.outcome == OrbitOutcome::grazing)
          << branch.sequence << " at " << branch.points[i].parameter << ": " << orbit.reason;
    }
  }
  ASSERT_NE(merged, nullptr);
  const SequencedOrbit seed = orbit_of(family, *merged, merged->points.size() / 2);
  const OrbitDiagram up = trace_diagram(family, {seed}, {.max_order = 1, .max_branches = 3});
  const auto interrupted =
      std::find_if(up.branches.begin(), up.branches.end(), [](const OrbitBranch& branch) {
        return branch.began.find("starts pressing, or opens") != std::string::npos;
      });
  ASSERT_NE(interrupted, up.branches.end());
  EXPECT_NEAR(interrupted->points.front().parameter, merged->points.front().parameter, 1e-10);
  EXPECT_GT(interrupted->points.size(), 10U);
  EXPECT_NE(interrupted->ended, "the corrector fails");
}

}  // namespace
}  // namespace signorini::sticking_changes_test
