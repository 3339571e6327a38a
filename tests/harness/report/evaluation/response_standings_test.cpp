#include "harness/report/evaluation/response_standings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::response_standings_test {
namespace {

TEST(ResponseStandings, RecommendTheCheapestOfThoseThatAreNearlyAsGoodAndNeverTheRuler) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "exact-orbit", 1.0, 0.0, 9.0);
  test::add_method(records, "most", 0.92, 0.04, 8.0);
  test::add_method(records, "nearly", 0.88, 0.06, 4.0);  // a share of false ones beyond 5 % is no cliff
  test::add_method(records, "cheap", 0.5, 0.0, 1.0);
  test::add_method(records, "inventive", 1.0, 0.6, 0.1);
  const std::vector<ResponseGroup> groups = response_groups(records);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].kind, SceneKind::rigid_stop);
  EXPECT_EQ(group_title(groups[0]), "Rigid stop (e = 1), 3 responses");
  ASSERT_EQ(groups[0].standings.size(), 5U);
  for (const ResponseStanding& one : groups[0].standings) {
    EXPECT_EQ(one.recommended, one.label == "nearly") << one.label;
    EXPECT_EQ(one.makes_the_exact, one.label == "exact-orbit") << one.label;
  }
  EXPECT_EQ(groups[0].standings[0].label, "nearly");
  EXPECT_EQ(groups[0].standings[1].label, "most");
  EXPECT_EQ(groups[0].standings[2].label, "cheap");  // 2/3 against 4/7 of what is mostly false
  EXPECT_EQ(groups[0].standings[4].label, "exact-orbit");
  EXPECT_DOUBLE_EQ(groups[0].standings[0].found, 0.88);
  EXPECT_DOUBLE_EQ(groups[0].standings[0].cost.value(), 4.0 / 1.5);
}

TEST(ResponseStandings, RecommendNothingOfTwoResponses) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "m", 0.5, 0.0, 1.0);
  test::add_method(records, "better", 1.0, 0.0, 1.0);
  std::erase_if(records, [](const Record& record) { return record.scene == "c"; });
  const ResponseGroup group = response_groups(records).at(0);
  EXPECT_TRUE(group.is_too_small());
  EXPECT_EQ(group.standings[0].label, "better");
  for (const ResponseStanding& one : group.standings) EXPECT_FALSE(one.recommended) << one.label;
}

TEST(ResponseStandings, CountAResponseThatAMethodDoesNotApplyToAsNotFound) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "half", 1.0, 0.0, 1.0);
  records.back().status = Status::not_applicable;
  records.back().response->comparison.reset();
  test::add_method(records, "all", 0.9, 0.0, 9.0);
  const std::vector<ResponseStanding> standings = response_groups(records).at(0).standings;
  EXPECT_EQ(standings[0].label, "all");
  EXPECT_TRUE(standings[0].recommended);
  EXPECT_DOUBLE_EQ(standings[1].found, 2.0 / 3.0);
  EXPECT_EQ(standings[1].asked, 2);
}

// Branches of restitution 1 cover part of those of restitution 0.8: right for no law of theirs.
TEST(ResponseStandings, CountABranchOfAnotherLawNowhere) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "m", 1.0, 0.0, 1.0);
  test::add_method(records, "n", 0.6, 0.0, 1.0);
  for (Record& record : records)
    if (record.method == "m" && record.scene == "b") record.law_matches_scene = false;
  const std::vector<ResponseStanding> standings = response_groups(records).at(0).standings;
  const ResponseStanding& mixed = *std::ranges::find(standings, "m", &ResponseStanding::label);
  EXPECT_DOUBLE_EQ(mixed.found, 2.0 / 3.0);
  EXPECT_EQ(mixed.asked, 2);
  EXPECT_EQ(mixed.points, 4);
  for (Record& record : records)
    if (record.method == "m") record.law_matches_scene = false;
  EXPECT_EQ(response_groups(records).at(0).standings.size(), 1U);
}

TEST(ResponseStandings, KeepKindsOfScenesApart) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "m", 0.9, 0.0, 1.0);
  for (Record& record : records)
    if (record.scene == "b") record.contacts = kManyContacts;
  const std::vector<ResponseGroup> groups = response_groups(records);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scenes, (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(groups[1].kind, SceneKind::many_contacts);
  for (Record& record : records) record.scene_law.reset();
  EXPECT_EQ(group_title(response_groups(records).at(0)), "Scenes of unrecorded law, 3 responses");
}

// As free motions are, which exact orbits alone follow; where there is nothing else they stand alone.
TEST(ResponseStandings, LeaveOutScenesThatNoOtherMethodAppliesTo) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"), test::exact_response("c"),
                              test::exact_response("free")};
  test::add_method(records, "exact-orbit", 1.0, 0.0, 9.0);
  test::add_method(records, "m", 0.9, 0.0, 1.0);
  records.push_back(test::response_of("free", "exact-orbit", 1.0, 1.0));
  records.push_back(test::response_of("free", "m", 0.0, 1.0));
  records.back().status = Status::not_applicable;
  records.back().response->comparison.reset();
  const ResponseGroup group = response_groups(records).at(0);
  EXPECT_EQ(group.scenes, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_DOUBLE_EQ(std::ranges::find(group.standings, "m", &ResponseStanding::label)->found, 0.9);
  std::erase_if(records, [](const Record& record) { return record.scene != "free"; });
  EXPECT_EQ(response_groups(records).at(0).scenes, std::vector<std::string>{"free"});
}

TEST(ResponseStandings, LeaveOutScenesThatNothingWasComparedOn) {
  Record failed = test::response_of("a", "m", 0.0, 1.0);
  failed.response->comparison.reset();
  EXPECT_TRUE(response_groups(std::vector{test::exact_response("a"), failed}).empty());
}

}  // namespace
}  // namespace signorini::response_standings_test
