#include "harness/run_folder/shards.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "harness/failure.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::shards_test {
namespace {

Plan plan_of_scenes(int scenes) {
  Plan plan;
  for (int i = 0; i < scenes; ++i) {
    plan.scenes.push_back(test::one_mass_scene());
    plan.scenes.back().problem.name = "scene-" + std::to_string(i);
    for (const char* behaviour : {"good", "give_up"}) {
      plan.cases.push_back(test::fake_case(plan.scenes.back(), behaviour));
      plan.cases.back().scene = static_cast<std::size_t>(i);
    }
  }
  return plan;
}

TEST(ParseShard, RefusesWhatIsNoPartOfAWhole) {
  EXPECT_EQ(parse_shard("2/3").index, 2);
  EXPECT_EQ(parse_shard("2/3").count, 3);
  for (const char* text : {"", "2", "0/3", "4/3", "1/0", "a/b", "1/3x", "-1/3", "1//3"})
    EXPECT_THROW(parse_shard(text), UsageError) << text;
}

TEST(TakeShard, CutsAPlanIntoPartsThatTogetherAreThePlan) {
  const Plan plan = plan_of_scenes(7);
  std::set<std::string> cases;
  std::size_t count = 0;
  for (int i = 1; i <= 3; ++i) {
    const Plan part = take_shard(plan, {i, 3}, {});
    for (const Case& run : part.cases) {
      cases.insert(run.id);
      EXPECT_EQ(run.id.rfind(part.scenes[run.scene].problem.name + "/", 0), 0U) << run.id;
    }
    EXPECT_EQ(part.cases.size(), 2 * part.scenes.size()) << "a scene is in two parts";
    count += part.cases.size();
  }
  EXPECT_EQ(count, plan.cases.size());
  EXPECT_EQ(cases.size(), plan.cases.size());
}

TEST(TakeShard, IsEmptyWhereThereAreFewerScenesThanParts) {
  EXPECT_TRUE(take_shard(plan_of_scenes(2), {3, 3}, {}).cases.empty());
}

TEST(TakeShard, PutsALongSceneAloneWherePastDurationsAreKnown) {
  const Plan plan = plan_of_scenes(5);
  std::vector<RecordEntry> records;
  for (const Case& run : plan.cases) {
    records.push_back(RecordEntry{.case_id = run.id, .method = std::string(run.choice.entry->name)});
    records.back().elapsed = run.scene == 3 ? 100.0 : 1.0;
  }
  const Durations durations(records);
  EXPECT_EQ(take_shard(plan, {1, 2}, durations).scenes.size(), 1U);
  EXPECT_EQ(take_shard(plan, {1, 2}, durations).scenes[0].problem.name, "scene-3");
  EXPECT_EQ(take_shard(plan, {2, 2}, durations).scenes.size(), 4U);
}

TEST(Durations, FallBackToTheMeanOfTheMethodThenOfAll) {
  std::vector<RecordEntry> records{RecordEntry{.case_id = "s/m[n=1]", .method = "m"},
                                   RecordEntry{.case_id = "s/m[n=2]", .method = "m"},
                                   RecordEntry{.case_id = "s/k", .method = "k"}};
  records[0].elapsed = 1.0;
  records[1].elapsed = 3.0;
  records[2].elapsed = 8.0;
  const Durations durations(records);
  EXPECT_EQ(durations.of("s/m[n=2]", "m"), 3.0);
  EXPECT_EQ(durations.of("t/m[n=1]", "m"), 2.0);
  EXPECT_EQ(durations.of("t/unknown", "unknown"), 4.0);
  EXPECT_EQ(Durations().of("anything", "any"), 1.0);
}

TEST(Balance, StaysWithinAThirdOfTheBest) {
  const std::vector<double> seconds{7.0, 7.0, 6.0, 6.0, 5.0, 5.0, 4.0, 4.0, 4.0};
  const std::vector<int> parts = balance(seconds, 3);
  std::vector<double> sums(3, 0.0);
  for (std::size_t i = 0; i < seconds.size(); ++i) sums[static_cast<std::size_t>(parts[i])] += seconds[i];
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0.0), 48.0);
  EXPECT_LE(*std::max_element(sums.begin(), sums.end()), 16.0 * 4.0 / 3.0);
  EXPECT_EQ(balance(seconds, 3), parts);
}

}  // namespace
}  // namespace signorini::shards_test
