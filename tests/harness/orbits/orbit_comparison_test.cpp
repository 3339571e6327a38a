#include <gtest/gtest.h>

#include "harness/orbits/orbit_file.hpp"
#include "tests/harness/orbits/sample_orbits.hpp"

namespace signorini::orbit_comparison_test {
namespace {

using test::sample_file;
using test::sample_orbit;

std::string only_difference(const OrbitFile& kept, const OrbitFile& now) {
  const OrbitDifferences result = compare_orbits(kept, now);
  EXPECT_EQ(result.differences.size(), 1U);
  return result.differences.empty() ? "" : result.differences.front();
}

void expect_difference(const std::function<void(FoundOrbit&)>& tamper, const std::string& text) {
  OrbitFile now = sample_file();
  tamper(now.orbits.front());
  const std::string line = only_difference(sample_file(), now);
  EXPECT_NE(line.find(text), std::string::npos) << line;
  EXPECT_EQ(line.rfind("some-scene: orbit 0badcafe of order 2: ", 0), 0U) << line;
}

TEST(CompareOrbits, FindsNoDifferenceInTheSame) {
  const OrbitDifferences result = compare_orbits(sample_file(), sample_file());
  EXPECT_TRUE(result.differences.empty());
  EXPECT_TRUE(result.fresh.empty());
}

TEST(CompareOrbits, TakesShiftsByAForcingPeriodForTheSame) {
  OrbitFile now = sample_file();
  now.orbits.front().certified.events = {{2.5, 0, ContactEvent::Kind::impact, -1.0},
                                         {3.5, 1, ContactEvent::Kind::close, {}},
                                         {3.75, 1, ContactEvent::Kind::open, {}}};
  EXPECT_TRUE(compare_orbits(sample_file(), now).differences.empty());
  for (OrbitEvent& event : now.orbits.front().certified.events) event.time -= 1.0;  // half a forcing period
  EXPECT_FALSE(compare_orbits(sample_file(), now).differences.empty());
}

TEST(CompareOrbits, AllowsWhatTheErrorBarsAllow) {
  OrbitFile now = sample_file();
  now.orbits.front().certified.events.front().time += 0.5 * kInstantFloor * 4.0;
  EXPECT_TRUE(compare_orbits(sample_file(), now).differences.empty());
  now.orbits.front().certified.events.front().time += 1e-5;
  EXPECT_FALSE(compare_orbits(sample_file(), now).differences.empty());
  now.orbits.front().certified.error_bar = 1e-6;
  EXPECT_TRUE(compare_orbits(sample_file(), now).differences.empty());
}

TEST(CompareOrbits, NamesWhatWasTamperedWith) {
  expect_difference([](FoundOrbit& o) { o.certified.events[0].time += 1e-6; },
                    "event 1 (impact at contact 0): time 0.5 s");
  expect_difference([](FoundOrbit& o) { o.certified.events[0].value = -1.01; },
                    "impulse -1 N s became -1.01 N s");
  expect_difference([](FoundOrbit& o) { o.certified.events.pop_back(); }, "3 events became 2");
  expect_difference([](FoundOrbit& o) { o.certified.events[1].contact = 0; },
                    "event 2 (close at contact 1) is gone");
  expect_difference([](FoundOrbit& o) { o.certified.stable = false; }, "stable became unstable");
  expect_difference([](FoundOrbit& o) { o.certified.stable.reset(); }, "of unknown stability");
  expect_difference(
      [](FoundOrbit& o) {
        (*o.certified.floquet)[1] = {0.5, -0.3};
      },
      "multiplier 0.5-0.25i became 0.5-0.3i");
  expect_difference([](FoundOrbit& o) { o.amplitude = 0.6; }, "amplitude 0.5 m became 0.6 m");
  expect_difference([](FoundOrbit& o) { o.fingerprint = "00000000"; }, "fingerprint became 00000000");
  expect_difference([](FoundOrbit& o) { o.from_rest = true; }, "became the one reached from rest");
}

TEST(CompareOrbits, MissesAnOrbitThatIsGoneAndReportsANewOne) {
  OrbitFile now = sample_file();
  now.orbits.front().order = 1;
  now.orbits.front().fingerprint = "11111111";
  EXPECT_NE(only_difference(sample_file(), now).find("not found again"), std::string::npos);
  const OrbitDifferences result = compare_orbits(sample_file(), now);
  ASSERT_EQ(result.fresh.size(), 1U);
  EXPECT_NE(result.fresh.front().find("orbit 11111111 of order 1, stable: new"), std::string::npos);
}

TEST(CompareOrbits, LeavesTheWeakImpactsOfAChatterAlone) {
  OrbitFile kept = sample_file(), now = sample_file();
  kept.orbits.front().certified.events.push_back({1.7, 0, ContactEvent::Kind::impact, -1e-4});
  EXPECT_TRUE(compare_orbits(kept, now).differences.empty());
}

TEST(CompareOrbits, HasOneLineForAnotherSceneOrLaw) {
  OrbitFile now = sample_file();
  now.scene_sha256 = "other";
  now.orbits.clear();
  EXPECT_NE(only_difference(sample_file(), now).find("scene file has changed"), std::string::npos);
  now = sample_file();
  now.law = Restitution{0.7};
  EXPECT_NE(only_difference(sample_file(), now).find("law became"), std::string::npos);
}

}  // namespace
}  // namespace signorini::orbit_comparison_test
