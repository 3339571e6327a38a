#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "harness/orbits/orbit_candidate.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::candidate_units_test {
namespace {

std::vector<std::string> names(const std::vector<CandidateUnit>& units) {
  std::vector<std::string> list;
  for (const CandidateUnit& unit : units) list.push_back(unit.name);
  return list;
}

std::vector<OrbitCandidate> results(const CandidateUnit& unit, Deadline deadline = Deadline::max()) {
  std::vector<OrbitCandidate> found;
  unit.work([&](const OrbitCandidate& candidate) { found.push_back(candidate); }, deadline);
  return found;
}

TEST(CandidateUnits, MarchFromRestAtOrderOneOnly) {
  const Problem problem = test::one_mass();
  EXPECT_EQ(names(candidate_units(problem, 1, 0, 1, {})),
            (std::vector<std::string>{"from rest", "coarse grids"}));
  EXPECT_EQ(names(candidate_units(problem, 2, 0, 1, {})), (std::vector<std::string>{"coarse grids"}));
}

TEST(CandidateUnits, SplitTheRandomStatesAndKeepTheirNumbers) {
  const std::vector<std::string> list = names(candidate_units(test::one_mass(), 2, 19, 1, {}));
  EXPECT_EQ(list, (std::vector<std::string>{"coarse grids", "random states 0..7", "random states 8..15",
                                            "random states 16..18"}));
}

TEST(CandidateUnits, StartAMethodFromEverySettingOnce) {
  const Problem problem = test::one_mass();
  std::vector<MethodEntry> catalogue{test::fake_catalogue().front()};
  catalogue.front().ladder = "behaviour=good|lie";
  catalogue.front().starts = "behaviour=waver|lie";
  // The default is "good": a step of the ladder that comes to the same options is no other start.
  EXPECT_EQ(names(candidate_units(problem, 2, 0, 1, catalogue)),
            (std::vector<std::string>{"fake-method", "fake-method[behaviour=lie]",
                                      "fake-method[behaviour=waver]", "coarse grids"}));
}

TEST(CandidateUnits, LeaveOutMethodsThatDoNotApply) {
  std::vector<MethodEntry> catalogue{test::fake_catalogue().front()};
  catalogue.front().ladder = "behaviour=unsupported";
  EXPECT_EQ(names(candidate_units(test::one_mass(), 2, 0, 1, catalogue)),
            (std::vector<std::string>{"fake-method", "coarse grids"}));
}

// The stop is 10 m away: nothing touches it, coming from rest.
TEST(CandidateUnits, FindTheContactFreeMotionFromRest) {
  const Problem problem = test::one_mass();
  const std::vector<OrbitCandidate> found = results(candidate_units(problem, 1, 0, 1, {}).front());
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found.front().orbit) << found.front().reason;
  EXPECT_TRUE(found.front().orbit->events.empty());
  EXPECT_TRUE(found.front().near);
}

TEST(CandidateUnits, DrawTheSameRandomStatesHoweverManyThereAre) {
  const Problem problem = test::one_mass();
  const std::vector<OrbitCandidate> one = results(candidate_units(problem, 2, 1, 7, {}).back());
  const std::vector<OrbitCandidate> two = results(candidate_units(problem, 2, 2, 7, {}).back());
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(one[0].source, "random state 0");
  EXPECT_EQ(two[1].source, "random state 1");
  EXPECT_EQ(to_json(one[0]).dump(), to_json(two[0]).dump());
}

TEST(CandidateUnits, BeginNothingAfterTheDeadline) {
  const Problem problem = test::one_mass();
  for (const CandidateUnit& unit : candidate_units(problem, 2, 8, 1, {}))
    EXPECT_TRUE(results(unit, Deadline::min()).empty()) << unit.name;
}

TEST(CandidateUnits, SayWhyAMethodLedNowhere) {
  const Problem problem = test::one_mass();
  std::vector<MethodEntry> catalogue{test::fake_catalogue().front()};
  catalogue.front().ladder = "behaviour=give_up|wrong_period|singular";
  const std::vector<CandidateUnit> units = candidate_units(problem, 2, 0, 1, catalogue);
  EXPECT_EQ(results(units[1]).front().reason, "the method did not converge");
  EXPECT_NE(results(units[2]).front().reason.find("no whole multiple"), std::string::npos);
  EXPECT_EQ(results(units[3]).front().reason, "the structure is singular");
}

}  // namespace
}  // namespace signorini::candidate_units_test
