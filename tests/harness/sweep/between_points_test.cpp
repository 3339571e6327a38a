// Whether the orbits between two points of a branch are motions of the scene: both points are, and a contact
// that passes its stop and comes back between them would not be seen at either.
//
// By default a few scenes; SIGNORINI_BETWEEN=SCENES:SEED for more, as 60:7.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "harness/sweep/branch_response.hpp"
#include "methods/exact_orbit/exact_diagram.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/continuation/station.hpp"
#include "methods/orbit/family/orbit_section.hpp"
#include "problems/assembly/chain.hpp"

namespace signorini::between_points_test {
namespace {

constexpr double kFrom = 0.4, kTo = 2.6;

// A chain of two to four masses, damping ratio about .01 to .1, with up to three harmonics of load and one to
// three stops on either side, rigid or, one scene in three, springs.
Problem random_chain(std::mt19937& random, int number) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const int masses = 2 + number % 3, stops = 1 + static_cast<int>(2.999 * share(random));
  const double damping = 0.02 * std::pow(10.0, share(random));
  Chain chain;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(0.5 + share(random));
    chain.springs.push_back(0.8 + 1.6 * share(random));
    chain.dampers.push_back(damping * (0.5 + share(random)));
  }
  Problem problem;
  problem.name = "random-chain";
  problem.structure = std::make_shared<const Structure>(assemble(chain));
  problem.frequency = kFrom;
  for (int harmonic = 1; harmonic <= 3; ++harmonic)
    problem.force.push_back({.dof = masses - 1,
                             .harmonic = harmonic,
                             .cos = harmonic == 1 ? 1.0 : 0.6 * (share(random) - 0.5),
                             .sin = harmonic == 1 ? 0.0 : 0.6 * (share(random) - 0.5)});
  for (int j = 0; j < stops; ++j) {
    const double side = j % 2 == 0 ? 1.0 : -1.0;
    problem.contacts.push_back({.normal = {{masses - 1 - j % masses, side}}, .gap = 0.1 + share(random)});
  }
  const double e = 0.3 + 0.7 * share(random), spring = std::pow(10.0, 1.0 + 2.0 * share(random));
  if (number % 3 == 2)
    problem.set_law(Penalty{.stiffness = std::vector<double>(problem.contacts.size(), spring)});
  else
    problem.set_law(Restitution{e});
  return problem;
}

struct Seen {
  long steps = 0, compared = 0, lost = 0, inadmissible = 0;
};

// The second of two neighbours in the unknowns of the first; empty where these are others.
std::optional<SequencedOrbit> in_unknowns_of(const SequencedOrbit& first, OrbitFamily& family,
                                             const SequencedOrbit& orbit) {
  if (orbit.x.size() != first.x.size()) return std::nullopt;  // the impacts of a chatter
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  const double phase = std::fmod(first.section - orbit.section + orbit.end(), orbit.end());
  return phase == 0.0 ? orbit : with_section(orbit, equations, phase);
}

// Five orbits between two neighbours, in planes across their chord.
void compare(OrbitFamily& family, const OrbitBranch& branch, std::size_t i, Seen& seen) {
  constexpr int kInside = 5;
  // Of a guard: a tenth of the speed below which a polish calls an impact grazing.
  constexpr double kPast = -1e-8;
  const SolutionPoint& a = branch.points[i];
  const SequencedOrbit first = orbit_of(family, branch, i);
  const auto second = in_unknowns_of(first, family, orbit_of(family, branch, i + 1));
  ++seen.steps;
  if (!second) return;
  const Eigen::VectorXd chord = second->x - first.x;
  if (chord.norm() == 0.0) return;
  ExtendedEquations equations(family, first);
  for (int k = 1; k <= kInside; ++k) {
    if (!correct(equations, first.x + k / (kInside + 1.0) * chord, chord.normalized())) {
      ++seen.lost;
      continue;
    }
    ++seen.compared;
    const OrbitSurvey found = survey(equations);
    const auto past = std::find_if(found.guards.begin(), found.guards.end(),
                                   [](const OrbitGuard& guard) { return guard.value < kPast; });
    if (past == found.guards.end()) continue;
    ++seen.inadmissible;
    fmt::print("  {} between {:.12g} and {:.12g}, point {} of {}: {} ({:.1e})\n", branch.sequence,
               a.parameter, branch.points[i + 1].parameter, i, branch.points.size(),
               describe(*past, equations.orbit(), equations.model().dynamics), past->value);
    return;
  }
}

TEST(BetweenPoints, EveryOrbitIsAMotionOfTheScene) {
  int scenes = 12;
  unsigned seed = 20261123;
  if (const char* asked = std::getenv("SIGNORINI_BETWEEN")) std::sscanf(asked, "%d:%u", &scenes, &seed);
  std::mt19937 random(seed);
  Seen seen;
  for (int number = 0; number < scenes; ++number) {
    const ParametrisedScene scene = over_frequency(random_chain(random, number), kFrom, kTo);
    const OrbitDiagram diagram = exact_diagram(scene, ExactOrbitMethod({}), {.max_branches = 16});
    OrbitFamily family(scene);
    for (const OrbitBranch& branch : diagram.branches) {
      for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) compare(family, branch, i, seen);
    }
    fmt::print("scene {}: {} branches\n", number, diagram.branches.size());
  }
  fmt::print("seed {}: {} steps, {} orbits between their points, {} not found, {} steps pass a stop\n", seed,
             seen.steps, seen.compared, seen.lost, seen.inadmissible);
  EXPECT_GT(seen.compared, 1000);
  EXPECT_LT(seen.lost, seen.compared / 100);
  EXPECT_EQ(seen.inadmissible, 0);
}

}  // namespace
}  // namespace signorini::between_points_test
