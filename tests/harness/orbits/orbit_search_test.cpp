// All orbits of a scene: a pair known in closed form, and that nothing is counted twice.

#include "harness/orbits/orbit_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "harness/judge/exact_certificate.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/records/record_json.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::orbit_search_test {
namespace {

/// One mass above resonance, e = 0.8: a stable orbit of order 2 with one impact beside an unstable one of
/// order 1 (docs: closed form of single-impact orbits; m, c, k, F, w, g = 1, 0.02, 1, 1, 4.1, 0.01).
Problem coexisting() {
  return parse_scene(
      "schema = 1\nname = \"pair\"\ntitle = \"t\"\nreference = \"r\"\ntags = [\"t\"]\n"
      "[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.02\nstiffness = 1.0\n"
      "[forcing]\nfrequency = 4.1\n[[forcing.term]]\ndof = 0\nharmonic = 1\ncos = 1.0\n"
      "[[contact]]\ndof = 0\ngap = 0.01\n[law]\nrestitution = 0.8\n",
      "pair.toml");
}

const SceneOrbits& orbits_of_pair() {
  static const Problem problem = coexisting();
  static const SceneOrbits found = find_all_orbits(problem, {.starts = 16, .subharmonics = 2});
  return found;
}

const FoundOrbit* single_impact(const SceneOrbits& found, int order) {
  for (const FoundOrbit& orbit : found.orbits) {
    if (orbit.order == order && orbit.impacts() == 1) return &orbit;
  }
  return nullptr;
}

std::complex<double> trace(const FoundOrbit& orbit) {
  std::complex<double> sum = 0.0;
  for (const auto& [re, im] : *orbit.certified.floquet) sum += std::complex(re, im);
  return sum;
}

std::complex<double> determinant(const FoundOrbit& orbit) {
  std::complex<double> product = 1.0;
  for (const auto& [re, im] : *orbit.certified.floquet) product *= std::complex(re, im);
  return product;
}

/// Impulse p = -m (1 + e) v of an impact at speed v.
double impact_speed(const FoundOrbit& orbit) { return -orbit.certified.events.front().value.value() / 1.8; }

TEST(FindAllOrbits, FindsTheStableSubharmonicOfAKnownPair) {
  const FoundOrbit* orbit = single_impact(orbits_of_pair(), 2);
  ASSERT_NE(orbit, nullptr);
  EXPECT_EQ(orbit->certified.stable, true);
  EXPECT_NEAR(impact_speed(*orbit), 1.245271157551, 1e-11);
  EXPECT_NEAR(trace(*orbit).real(), 1.4561967318, 1e-9);
  EXPECT_NEAR(determinant(*orbit).real(), 0.6019466424, 1e-9);
  EXPECT_NEAR(trace(*orbit).imag(), 0.0, 1e-9);
  // Impacts at 0.624435604230 s after a period of the load began, whichever of the two.
  const double forcing_period = orbit->period / 2;
  EXPECT_NEAR(std::remainder(orbit->certified.events.front().time - 0.624435604230, forcing_period), 0.0,
              1e-11);
}

TEST(FindAllOrbits, FindsTheUnstableOrbitThatCoexists) {
  const FoundOrbit* orbit = single_impact(orbits_of_pair(), 1);
  ASSERT_NE(orbit, nullptr);
  EXPECT_EQ(orbit->certified.stable, false);
  EXPECT_NEAR(impact_speed(*orbit), 0.056924256179, 1e-11);
  // Whatever the orbit, an impact multiplies areas by e^2 and the flow by exp(-c T / m).
  EXPECT_NEAR(determinant(*orbit).real(), 0.64 * std::exp(-0.02 * orbit->period), 1e-9);
  EXPECT_GT(orbit->largest_multiplier().value(), 1.0);
}

TEST(FindAllOrbits, ListsEveryOrbitOnceWhateverItsOrderAndShift) {
  const SceneOrbits& found = orbits_of_pair();
  std::set<std::string> names;
  int hits = 0;
  for (const FoundOrbit& orbit : found.orbits) {
    EXPECT_TRUE(names.insert(orbit.fingerprint).second) << orbit.fingerprint;
    EXPECT_NEAR(orbit.period, orbit.order * 2.0 * std::numbers::pi / 4.1, 1e-12);
    hits += orbit.starts;
  }
  int failures = 0;
  for (const auto& [reason, count] : found.failures) failures += count;
  EXPECT_EQ(hits + failures, found.searches);
  // Starts at order 2 lead to the orbit of order 1 as well, and to both shifts of the subharmonic.
  EXPECT_GT(hits, static_cast<int>(found.orbits.size()));
}

TEST(FindAllOrbits, CertifiesEveryOrbitByASecondIntegrator) {
  for (const FoundOrbit& orbit : orbits_of_pair().orbits) {
    ASSERT_TRUE(orbit.certified.return_distance.has_value());
    EXPECT_LT(orbit.certified.error_bar, 1e-9);
    EXPECT_LT(orbit.certified.residual.value(), 1e-11);
  }
}

TEST(FindAllOrbits, IsTheSameForTheSameSeed) {
  const Problem problem = coexisting();
  const OrbitSearchOptions options{.starts = 16, .subharmonics = 2};
  const SceneOrbits again = find_all_orbits(problem, options);
  const Scene scene{problem, "hash"};
  EXPECT_EQ(print_orbit_file(make_orbit_file(scene, options, again)),
            print_orbit_file(make_orbit_file(scene, options, orbits_of_pair())));
  EXPECT_EQ(again.failures, orbits_of_pair().failures);
}

TEST(FindAllOrbits, NamesTheMotionFromRestAndTheMethodsThatFindAnOrbitCold) {
  const SceneOrbits& found = orbits_of_pair();
  const auto from_rest = std::count_if(found.orbits.begin(), found.orbits.end(),
                                       [](const FoundOrbit& orbit) { return orbit.from_rest; });
  EXPECT_EQ(from_rest, 1);
  for (const FoundOrbit& orbit : found.orbits) {
    // Marching goes to stable motions only.
    if (orbit.from_rest) {
      EXPECT_EQ(orbit.certified.stable, true);
    }
    if (orbit.certified.stable == false) {
      for (const std::string& label : orbit.cold) EXPECT_EQ(label.find("event-driven"), std::string::npos);
    }
  }
}

TEST(CertifyAgain, ComesBackToAnOrbitFromItsEventsAlone) {
  const Problem problem = coexisting();
  for (const FoundOrbit& orbit : orbits_of_pair().orbits) {
    FoundOrbit kept = orbit;
    kept.certified.motion = nullptr;
    kept.certified.events.front().time += 1e-4;
    const std::optional<FoundOrbit> again = certify_again(problem, kept, Deadline::max());
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->fingerprint, orbit.fingerprint);
    EXPECT_NEAR(again->certified.events.front().time, orbit.certified.events.front().time, 1e-11);
    EXPECT_EQ(again->certified.stable, orbit.certified.stable);
  }
}

TEST(CertifyAgain, KnowsContactPhasesFromTheirEvents) {
  const Problem problem = load_scene(find_scene("sdof-stick"));
  const SceneOrbits found = find_all_orbits(problem, {.starts = 0, .subharmonics = 1});
  ASSERT_EQ(found.orbits.size(), 1U);
  ASSERT_EQ(found.orbits.front().contact_phases(), 1);
  FoundOrbit kept = found.orbits.front();
  kept.certified.motion = nullptr;
  const std::optional<FoundOrbit> again = certify_again(problem, kept, Deadline::max());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->fingerprint, kept.fingerprint);
}

// A mass on a damper alone, whose forced motion of amplitude F / |i c w - m w^2| may be anywhere between its
// stops.
TEST(FindAllOrbits, ListsOneOfAFamilyOfMotionsThatTouchNothing) {
  const Problem floating = parse_scene(
      "schema = 1\nname = \"floating\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.3\nstiffness = "
      "0.0\n[forcing]\nfrequency = 1.7\n[[forcing.term]]\ndof = 0\ncos = 0.14\n[[contact]]\ndof = "
      "0\nclearance = 0.5\nrestitution = 0.9\n",
      "floating.toml");
  const SceneOrbits found = find_all_orbits(floating, {.starts = 8, .subharmonics = 2});
  int families = 0;
  for (const FoundOrbit& orbit : found.orbits) {
    if (!orbit.certified.events.empty()) continue;
    ++families;
    EXPECT_EQ(orbit.order, 1);
    EXPECT_NEAR(orbit.amplitude, 0.14 / std::hypot(0.3 * 1.7, 1.7 * 1.7), 1e-6);
    EXPECT_NE(orbit.certified.undefined.find("one of a family of free motions"), std::string::npos);
    EXPECT_FALSE(orbit.certified.stable.has_value());
    EXPECT_GT(orbit.starts, 10) << "the coarse grids and states that settle, wherever";
  }
  EXPECT_EQ(families, 1);
}

// Whatever the rounding of a state that settles to it.
TEST(FindAllOrbits, ListsTheStateOfRestOnce) {
  Problem unloaded = read_scene(find_scene("chain2-penalty")).problem;
  unloaded.force.clear();
  const SceneOrbits found = find_all_orbits(unloaded, {.starts = 4, .subharmonics = 1});
  ASSERT_EQ(found.orbits.size(), 1U);
  EXPECT_EQ(found.orbits[0].amplitude, 0.0);
  EXPECT_GT(found.orbits[0].starts, 10);
}

TEST(FindAllOrbits, LeavesOutWhatIsNotCertified) {
  const Problem problem = coexisting();
  const OrbitPolisher refuse = [](const Problem&, const Trajectory&, std::span<const Certificate>,
                                  Deadline) -> CertifiedOrbit { return {.reason = "no second integrator"}; };
  const SceneOrbits found = find_all_orbits(problem, {.starts = 0, .subharmonics = 1}, refuse);
  EXPECT_TRUE(found.orbits.empty());
  EXPECT_GT(found.failures.at("no second integrator"), 0);
}

TEST(FindAllOrbits, StopsAtItsTimeLimit) {
  const Problem problem = coexisting();
  const SceneOrbits found = find_all_orbits(problem, {.starts = 8, .timeout = 1e-6});
  EXPECT_TRUE(found.expired);
  EXPECT_FALSE(found.interrupted);
}

TEST(OrbitCandidates, AreTheSameStatesFirstWhateverTheirNumber) {
  const Problem problem = coexisting();
  const auto some = candidate_units(problem, 1, 3, 7), more = candidate_units(problem, 1, 8, 7);
  ASSERT_EQ(some.size(), more.size());
  std::vector<std::string> first, second;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  some.back().work([&](const OrbitCandidate& one) { first.push_back(to_json(one).dump()); }, deadline);
  more.back().work([&](const OrbitCandidate& one) { second.push_back(to_json(one).dump()); }, deadline);
  ASSERT_EQ(first.size(), 3U);
  ASSERT_EQ(second.size(), 8U);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), second.begin()));
}

}  // namespace
}  // namespace signorini::orbit_search_test
