#include "harness/report/evaluation/scene_groups.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini::scene_groups_test {
namespace {

Record with_law(Record record, const RepresentedLaw& law) {
  record.scene_law = record.law = law;
  return record;
}

Record sample() { return test::good_record("s", "m", "n=1", 1e-3, 1.0); }

TEST(KindOf, IsThatOfTheLawUnlessThereAreManyContactsOrCoordinates) {
  EXPECT_EQ(kind_of(case_scene_of(with_law(sample(), Restitution{1.0}))), SceneKind::rigid_stop);
  EXPECT_EQ(kind_of(case_scene_of(with_law(sample(), Restitution{0.99}))), SceneKind::restitution);
  EXPECT_EQ(kind_of(case_scene_of(with_law(sample(), Restitution{0.0}))), SceneKind::restitution);
  EXPECT_EQ(kind_of(case_scene_of(with_law(sample(), Penalty{{1e3}}))), SceneKind::spring);
  EXPECT_EQ(kind_of(case_scene_of(with_law(sample(), Massless{}))), SceneKind::massless);
  Record record = with_law(sample(), Penalty{{1e3}});
  record.contacts = kManyContacts - 1;
  record.coordinates = kLargeStructure - 1;
  EXPECT_EQ(kind_of(case_scene_of(record)), SceneKind::spring);
  record.contacts = kManyContacts;
  EXPECT_EQ(kind_of(case_scene_of(record)), SceneKind::many_contacts);
  record.coordinates = kLargeStructure;
  EXPECT_EQ(kind_of(case_scene_of(record)), SceneKind::large_structure);
}

TEST(KindOf, IsNoneWithoutContactOrLaw) {
  Record record = with_law(sample(), std::monostate{});
  record.coordinates = kLargeStructure;
  EXPECT_EQ(kind_of(case_scene_of(record)), std::nullopt);
  record.scene_law.reset();
  EXPECT_EQ(kind_of(case_scene_of(record)), std::nullopt);
}

/// Names of the standings, a star before those that are recommended.
std::vector<std::string> order(const SceneGroup& group) {
  std::vector<std::string> names;
  for (const Standing& standing : group.standings)
    names.push_back((standing.recommended ? "*" : "") + standing.configuration);
  return names;
}

/// One run on each of three scenes, with these errors, all of this time.
void add(std::vector<Record>& records, const std::string& method, const std::array<double, 3>& errors,
         double seconds) {
  for (std::size_t i = 0; i < errors.size(); ++i)
    records.push_back(test::good_record("s" + std::to_string(i), method, "n=1", errors[i], seconds));
}

using Names = std::vector<std::string>;

TEST(SceneGroups, PutScenesSolvedBeforeTime) {
  std::vector<Record> records;
  add(records, "quick-on-two", {9e-3, 9e-3, 2e-2}, 1e-6);
  add(records, "slow", {9e-3, 9e-3, 9e-3}, 2.0);
  add(records, "slower", {1e-9, 1e-9, 1e-9}, 3.0);
  const Evaluation evaluation(records);
  const std::vector<SceneGroup> groups = scene_groups(evaluation);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].kind, SceneKind::rigid_stop);
  EXPECT_EQ(groups[0].scenes, (Names{"s0", "s1", "s2"}));
  EXPECT_EQ(order(groups[0]), (Names{"*slow", "slower", "quick-on-two"}));
  EXPECT_EQ(groups[0].standings[2].reach[0].scenes, 3);
  EXPECT_EQ(groups[0].standings[2].reach[1].scenes, 2);
  EXPECT_EQ(groups[0].standings[2].reach[2].scenes, 0);
  EXPECT_EQ(groups[0].standings[1].reach[3].median_seconds(), 3.0);
}

TEST(SceneGroups, RecommendAllThatTieAndNobodyWhereNobodyGetsThere) {
  std::vector<Record> records;
  add(records, "b", {1e-3, 1e-3, 1e-3}, 1.0);
  add(records, "a", {1e-3, 1e-3, 1e-3}, 1.0);
  add(records, "near", {1e-3, 1e-3, 1e-3}, 1.09);
  add(records, "far", {1e-3, 1e-3, 1e-3}, 1.11);
  EXPECT_EQ(order(scene_groups(Evaluation(records))[0]), (Names{"*a", "*b", "*near", "far"}));
  std::vector<Record> coarse;
  add(coarse, "a", {0.05, 0.05, 0.05}, 1.0);
  add(coarse, "failing", {0.05, 0.05, 0.05}, 0.5);
  for (Record& record : coarse) {
    if (record.method == "failing") record.status = Status::timeout;
  }
  EXPECT_EQ(order(scene_groups(Evaluation(coarse))[0]), (Names{"a", "failing"}));
}

TEST(SceneGroups, CountScenesOfAnotherLawAsNotReachedAndLeaveOutWhoRepresentsNone) {
  std::vector<Record> records;
  add(records, "all", {1e-3, 1e-3, 1e-3}, 1.0);
  add(records, "one", {1e-3, 1e-3, 1e-3}, 0.1);
  add(records, "none", {1e-3, 1e-3, 1e-3}, 0.1);
  for (Record& record : records) {
    record.law_matches_scene = record.method == "all" || (record.method == "one" && record.scene == "s0");
  }
  const SceneGroup group = scene_groups(Evaluation(records)).front();
  EXPECT_EQ(order(group), (Names{"*all", "one"}));
  EXPECT_EQ(group.standings[1].reach[1].scenes, 1);
  EXPECT_EQ(group.standings[1].reach[1].median_seconds(), kNeverReached);
}

TEST(SceneGroups, KeepTheKindsApart) {
  std::vector<Record> records;
  add(records, "m", {1e-3, 1e-3, 1e-3}, 1.0);
  records[0] = with_law(records[0], Massless{});
  records[2] = with_law(records[2], std::monostate{});
  const std::vector<SceneGroup> groups = scene_groups(Evaluation(records));
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scenes, (Names{"s1"}));
  EXPECT_EQ(groups[1].kind, SceneKind::massless);
  EXPECT_EQ(groups[1].scenes, (Names{"s0"}));
  EXPECT_TRUE(scene_groups(Evaluation({})).empty());
}

}  // namespace
}  // namespace signorini::scene_groups_test
