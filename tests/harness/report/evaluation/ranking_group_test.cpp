#include "harness/report/evaluation/ranking_group.hpp"

#include <gtest/gtest.h>

#include "harness/report/evaluation/work_precision.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

using Names = std::vector<std::string>;

/// Two scenes that a, b and c represent; one that b does not.
std::vector<Record> three_scenes() {
  std::vector<Record> records;
  for (const char* scene : {"s1", "s2", "s3"}) {
    for (const char* method : {"a", "b", "c"})
      records.push_back(test::good_record(scene, method, "n=1", 1e-3, 1.0));
  }
  records[7].law_matches_scene = false;  // b on s3
  return records;
}

TEST(RankingGroups, NeverRankAMethodWithThoseThatSolveAnotherLaw) {
  const std::vector<Record> records = three_scenes();
  const std::vector<ResolutionStudy> studies = resolution_studies(records);
  const std::vector<RankingGroup> groups = ranking_groups(studies);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scenes, (Names{"s1", "s2"}));
  EXPECT_EQ(groups[0].configurations, (Names{"a", "b", "c"}));
  EXPECT_EQ(groups[1].scenes, (Names{"s3"}));
  EXPECT_EQ(groups[1].configurations, (Names{"a", "c"}));
}

TEST(RankingGroups, CountWhatDoesNotApplyAsUnsolvedUnlessItAppliesNowhere) {
  std::vector<Record> records = three_scenes();
  records[7].law_matches_scene = true;
  records[1].status = Status::not_applicable;  // b on s1
  for (const std::size_t c : {2U, 5U, 8U}) records[c].status = Status::not_applicable;
  const std::vector<ResolutionStudy> studies = resolution_studies(records);
  const std::vector<RankingGroup> groups = ranking_groups(studies);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].configurations, (Names{"a", "b"}));
  const Costs costs = costs_to_error(groups[0], time_axis(), 1e-2);
  EXPECT_EQ(costs[1], (std::vector<double>{kNeverReached, 1.0, 1.0}));
}

TEST(RankingGroups, KeepScenesThatNobodySolves) {
  std::vector<Record> records = three_scenes();
  for (const std::size_t i : {0U, 1U, 2U}) records[i].status = Status::timeout;
  const std::vector<ResolutionStudy> studies = resolution_studies(records);
  EXPECT_EQ(ranking_groups(studies)[0].scenes, (Names{"s1", "s2"}));
}

}  // namespace
}  // namespace signorini
