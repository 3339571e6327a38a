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
  record = with_law(record, MixedLaws{{Restitution{0.5}, Massless{}}});
  EXPECT_EQ(kind_of(case_scene_of(record)), SceneKind::mixed_laws) << "whatever the structure";
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
  EXPECT_EQ(order(groups[0]), (Names{"*slow", "slower", "*quick-on-two"}));
  EXPECT_EQ(groups[0].standings[0].reason, "most scenes, fastest");
  EXPECT_EQ(groups[0].standings[2].reason, "one stable motion fewer, 2e+06 times as fast");
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

TEST(SceneGroups, NameBothWhereOneSceneDecides) {
  std::vector<Record> records;
  add(records, "thorough", {9e-3, 9e-3, 9e-3}, 0.43);
  add(records, "quick", {9e-3, 9e-3, 2e-2}, 0.05);
  add(records, "quick-too", {9e-3, 9e-3, 2e-2}, 0.06);
  add(records, "slow", {9e-3, 9e-3, 2e-2}, 0.42);
  const SceneGroup group = scene_groups(Evaluation(records)).front();
  EXPECT_EQ(order(group), (Names{"*thorough", "*quick", "quick-too", "slow"}));
  EXPECT_EQ(group.standings[0].reason, "most scenes");
  EXPECT_EQ(group.standings[1].reason, "one stable motion fewer, 8.6 times as fast");
  std::erase_if(records, [](const Record& record) { return record.method.starts_with("quick"); });
  EXPECT_EQ(order(scene_groups(Evaluation(records)).front()), (Names{"*thorough", "slow"}))
      << "no faster than the machine is steady";
}

TEST(SceneGroups, RecommendNothingOfTwoScenes) {
  std::vector<Record> records;
  add(records, "m", {1e-3, 1e-3, 1e-3}, 1.0);
  records.pop_back();
  const SceneGroup group = scene_groups(Evaluation(records)).front();
  EXPECT_TRUE(group.is_too_small());
  EXPECT_EQ(order(group), (Names{"m"}));
}

TEST(SceneGroups, PutScenesThatAMotionWithoutContactSolvesIntoAGroupOfTheirOwn) {
  std::vector<Record> records;
  add(records, "m", {1e-3, 1e-3, 1e-3}, 1.0);
  add(records, "other", {1e-3, 1e-3, 1e-3}, 1.0);
  for (Record& record : records) {
    record.physics.contact_ratio = 0.2;
    record.certificate.events = {{.kind = ContactEvent::Kind::close}, {.kind = ContactEvent::Kind::open}};
  }
  // One of two answers on s0: the other one found another motion of the scene.
  records[0].certificate.events.clear();
  records[0].physics.contact_ratio = 0.0;
  // A contact that is closed throughout on s1.
  records[1].certificate.events.clear();
  records[1].physics.contact_ratio = 1.0;
  const std::vector<SceneGroup> groups = scene_groups(Evaluation(records));
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scenes, (Names{"s1", "s2"}));
  EXPECT_EQ(groups[0].standings[0].reach[0].seconds.size(), 2U) << "neither for nor against";
  EXPECT_EQ(groups[1].kind, SceneKind::contact_free);
  EXPECT_EQ(groups[1].scenes, (Names{"s0"}));
  // An answer that nothing certifies moves no scene.
  records[0].certificate.status = CertificateStatus::uncertified;
  EXPECT_EQ(scene_groups(Evaluation(records)).size(), 1U);
}

TEST(SceneGroups, CountMotionsThatNobodyWillMeasure) {
  std::vector<Record> records;
  add(records, "m", {1e-3, 1e-3, 5e-2}, 1.0);
  records[0].certificate.stable = true;
  records[2].certificate.stable = false;
  // A faster run found an unstable motion of s1, and stands for it.
  records.push_back(test::good_record("s1", "m", "n=2", 1e-3, 0.1));
  records.back().certificate.stable = false;
  const Standing standing = scene_groups(Evaluation(records)).front().standings.front();
  EXPECT_EQ(standing.reach[0].scenes, 3);
  EXPECT_EQ(standing.reach[0].stable, 1);
  EXPECT_EQ(standing.reach[0].unstable, 2);
  EXPECT_EQ(standing.reach[1].unstable, 1);
}

TEST(SceneGroups, RecommendByTheMotionsThatAreNotUnstable) {
  std::vector<Record> records;
  add(records, "steady", {1e-3, 1e-3, 1e-3}, 2.0);
  add(records, "unsteady", {1e-3, 1e-3, 1e-3}, 1.9);
  records[4].certificate.stable = records[5].certificate.stable = false;
  EXPECT_EQ(order(scene_groups(Evaluation(records))[0]), (Names{"*steady", "unsteady"}));
  records[5].certificate.stable.reset();
  EXPECT_EQ(order(scene_groups(Evaluation(records))[0]), (Names{"*steady", "unsteady"}))
      << "one scene fewer, not much faster";
  for (Record& record : records) record.certificate.stable = false;
  EXPECT_EQ(order(scene_groups(Evaluation(records))[0]), (Names{"unsteady", "steady"}));
}

TEST(SceneGroups, ShowOneResultOnce) {
  std::vector<Record> records;
  add(records, "first", {1e-3, 1e-3, 1e-3}, 1.0);
  add(records, "same-bits", {1e-3, 1e-3, 1e-3}, 2.0);
  add(records, "same-equations", {1e-3, 1e-3, 1e-3}, 1.05);
  add(records, "another", {1e-3, 1e-3, 1e-3}, 3.0);
  for (Record& record : records) record.answer = record.scene + record.method;
  for (Record& record : records)
    if (record.method == "same-bits") record.answer = record.scene + "first";
  for (Record& record : records) record.options = {{"n", 1L}};
  for (Record& record : records)
    if (record.method == "same-equations") record.same_equations_as = "first";
  const auto standings = [&] { return scene_groups(Evaluation(records)).front().standings; };
  ASSERT_EQ(standings().size(), 2U);
  EXPECT_EQ(standings()[0].names(), "first = same-equations = same-bits");
  EXPECT_EQ(standings()[1].names(), "another");
  // One answer that differs makes two results; other options other equations.
  records[4].answer = "by a bit";
  records[7].options = {{"n", 2L}};
  EXPECT_EQ(standings().size(), 4U);
  EXPECT_EQ(order(scene_groups(Evaluation(records)).front()),
            (Names{"*first", "*same-equations", "same-bits", "another"}));
  // Answers of earlier versions have no digest.
  for (Record& record : records) record.answer.clear();
  EXPECT_EQ(standings().size(), 4U);
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
