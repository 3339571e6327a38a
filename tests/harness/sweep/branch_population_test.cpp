// Whether the branches of a scene hold the stable orbits that a search finds at random frequencies: two
// programs that share no way to their orbits; and whether the branches are sound.
//
// By default a few scenes; SIGNORINI_BRANCHES=SCENES:FREQUENCIES:SEED for more, as 70:20:1.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "harness/orbits/orbit_search.hpp"
#include "harness/sweep/branch_response.hpp"
#include "methods/exact_orbit/exact_diagram.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/survey.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/harness/sweep/random_scenes.hpp"
#include "tests/harness/sweep/sound_branches.hpp"

namespace signorini::branch_population_test {
namespace {

constexpr double kFrom = 0.7, kTo = 3.0;
constexpr int kOrders = 2;

struct Extent {
  int scenes = 8, frequencies = 2;
  unsigned seed = 20261124;
};

Extent extent() {
  Extent result;
  if (const char* asked = std::getenv("SIGNORINI_BRANCHES"))
    std::sscanf(asked, "%d:%d:%u", &result.scenes, &result.frequencies, &result.seed);
  return result;
}

// Whether some branch has an orbit of this order, number of impacts, largest multiplier and amplitude, which
// the search samples, at a frequency. Of a complete chatter the impacts are infinitely many, of which both
// resolve so many.
bool holds(OrbitFamily& family, const OrbitDiagram& diagram, double frequency, const FoundOrbit& sought) {
  constexpr double kSameAmplitude = 1e-3, kSameMultiplier = 1e-5;
  for (const OrbitBranch& branch : diagram.branches) {
    if (branch.points.front().order != sought.order) continue;
    for (const SequencedOrbit& orbit : orbits_at(family, branch, frequency)) {
      ExtendedEquations equations(family, orbit);
      if (!equations.evaluate(orbit.x)) continue;
      const auto impacts = std::count_if(orbit.events.begin(), orbit.events.end(), [](const auto& event) {
        return event.kind == ContactEvent::Kind::impact;
      });
      const OrbitSurvey found = survey(equations);
      const double amplitude = 0.5 * (found.highest - found.lowest).maxCoeff();
      const double largest = general_eigenvalues(equations.monodromy()).cwiseAbs().maxCoeff();
      const bool chatters = !chatter_ends(equations).empty();
      if (chatters == (sought.contact_phases() > 0) && (chatters || impacts == sought.impacts()) &&
          std::abs(amplitude - sought.amplitude) < kSameAmplitude * sought.amplitude &&
          std::abs(largest - *sought.largest_multiplier()) < kSameMultiplier)
        return true;
    }
  }
  return false;
}

TEST(BranchPopulation, HoldsTheStableOrbitsThatASearchFinds) {
  const Extent asked = extent();
  std::mt19937 random(asked.seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int stable = 0, held = 0;
  for (int number = 0; number < asked.scenes; ++number) {
    const Problem problem = test::random_scene(random, number);
    const ParametrisedScene scene = over_frequency(problem, kFrom, kTo);
    const OrbitDiagram diagram = exact_diagram(scene, ExactOrbitMethod({}), {.max_order = kOrders});
    SCOPED_TRACE(number);
    (void)test::expect_orbits_of(scene, diagram);
    OrbitFamily family(scene);
    for (int k = 0; k < asked.frequencies; ++k) {
      const double frequency = kFrom + (kTo - kFrom) * share(random);
      for (const FoundOrbit& orbit :
           find_all_orbits(scene.at(frequency), {.starts = 12, .subharmonics = kOrders}).orbits) {
        if (orbit.order > kOrders || !(orbit.largest_multiplier().value_or(2.0) < 1.0)) continue;
        ++stable;
        if (holds(family, diagram, frequency, orbit)) {
          ++held;
          continue;
        }
        fmt::print(
            "missed: scene {} at {:.6f}, order {}, {} impacts, {} phases of contact, amplitude {:.6f}\n",
            number, frequency, orbit.order, orbit.impacts(), orbit.contact_phases(), orbit.amplitude);
      }
    }
    fmt::print("scene {}: {} branches; {} of {} stable orbits so far\n", number, diagram.branches.size(),
               held, stable);
  }
  EXPECT_GE(stable, asked.scenes);
  EXPECT_GE(held, 0.85 * stable);
}

}  // namespace
}  // namespace signorini::branch_population_test
