#include "harness/report/evaluation/ranking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "harness/report/evaluation/resolution_study.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::ranking_test {
namespace {

constexpr double kFails = std::numeric_limits<double>::infinity();

TEST(ShiftedGeometricMean, IsTheGeometricMeanWithoutAShift) {
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{1.0, 100.0}, 0.0, 0.0), 10.0, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{2.0, 2.0, 2.0}, 5.0, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{1.0, 7.0}, 1.0, 0.0), 3.0, 1e-12);
}

TEST(ShiftedGeometricMean, DependsOnItsShiftWhichMustThereforeBeSaid) {
  // Milliseconds on most scenes against seconds on some: the shift decides who wins.
  const std::vector<double> mostly_fast{0.001, 0.001, 0.001, 8.0};
  const std::vector<double> even{0.2, 0.2, 0.2, 0.2};
  const auto ratio = [&](double shift) {
    return shifted_geometric_mean(mostly_fast, shift, 0.0) / shifted_geometric_mean(even, shift, 0.0);
  };
  EXPECT_LT(ratio(0.0), 0.1);
  EXPECT_LT(ratio(kMeanShift), 0.5);
  EXPECT_GT(ratio(1.0), 1.0);
  EXPECT_GT(ratio(10.0), 1.0);
}

TEST(Aggregates, DoNotRewardFragility) {
  // Three of eight in 2 s on average against eight of eight in 27 s: the mean over survivors misleads.
  const std::vector<double> fragile{1.0, 2.0, 3.0, kFails, kFails, kFails, kFails, kFails};
  const std::vector<double> robust{4.0, 6.0, 8.0, 12.0, 20.0, 30.0, 50.0, 86.0};
  EXPECT_EQ(solved_count(fragile), 3);
  EXPECT_EQ(solved_count(robust), 8);
  EXPECT_GT(shifted_geometric_mean(fragile, 1.0, 100.0), shifted_geometric_mean(robust, 1.0, 100.0));
  EXPECT_GT(par2(fragile, 100.0), 4.0 * par2(robust, 100.0));
}

TEST(Par2, ChargesAFailureTwiceTheLimit) {
  EXPECT_DOUBLE_EQ(par2(std::vector<double>{1.0, kFails}, 10.0), 10.5);
}

TEST(PerformanceProfile, NeverCountsAFailureAsASuccessHoweverLargeTheFactor) {
  // A solves two of three, B one, one is failed by both. With failures set to a time limit of 1000 s both
  // would reach 1, A at factor 1 and B at some 1100.
  const PerformanceProfile profile = performance_profile({{1.0, 0.9, kFails}, {kFails, 1.8, kFails}});
  EXPECT_EQ(profile.scenes, 3U);
  EXPECT_DOUBLE_EQ(profile.share(0, 1.0), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(profile.share(0, 1e12), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(profile.share(1, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(profile.share(1, 2.0), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(profile.share(1, kFails), 1.0 / 3.0);
}

TEST(PerformanceProfile, DoesNotShiftZeroCosts) {
  const PerformanceProfile profile = performance_profile({{0.0, 0.0}, {0.0, 3.0}});
  EXPECT_DOUBLE_EQ(profile.share(0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(profile.share(1, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.share(1, 1e12), 0.5);  // no factor of nothing gives three
}

TEST(PerformanceProfile, IsEmptyWithoutScenes) {
  EXPECT_DOUBLE_EQ(performance_profile({{}, {}}).share(1, 1.0), 0.0);
  EXPECT_EQ(performance_profile({}).scenes, 0U);
}

TEST(PerformanceProfile, OfTwoRanksThoseThatAJointOneGetsWrong) {
  // Gould and Scott: beside A, B looks better than C; without A, C is better than B on five of eight.
  const Costs costs{{1.0, 1.0, 1.0, 1.0, 9.0, 9.0, 9.0, 9.0},
                    {4.0, 4.0, 4.0, 4.0, 1.0, 1.0, 1.0, 4.0},
                    {2.0, 2.0, 2.0, 2.0, 8.0, 8.0, 8.0, 1.0}};
  const PerformanceProfile joint = performance_profile(costs);
  EXPECT_DOUBLE_EQ(joint.share(1, 1.0), 3.0 / 8.0);
  EXPECT_DOUBLE_EQ(joint.share(2, 1.0), 1.0 / 8.0);
  const PerformanceProfile pair = performance_profile({costs[1], costs[2]});
  EXPECT_DOUBLE_EQ(pair.share(0, 1.0), 3.0 / 8.0);
  EXPECT_DOUBLE_EQ(pair.share(1, 1.0), 5.0 / 8.0);
}

TEST(PerformanceProfile, CountsTiesForBoth) {
  const PerformanceProfile pair = performance_profile({{1.0, kFails}, {1.0, kFails}});
  EXPECT_DOUBLE_EQ(pair.share(0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(pair.share(1, 1.0), 0.5);
}

using Names = std::vector<std::string>;

bool every_scene(const std::string&) { return true; }

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
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  const std::vector<RankingGroup> groups = ranking_groups(studies, every_scene);
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
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  const std::vector<RankingGroup> groups = ranking_groups(studies, every_scene);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].configurations, (Names{"a", "b"}));
  const Costs costs = costs_to_error(groups[0], time_axis(), 1e-2);
  EXPECT_EQ(costs[1], (std::vector<double>{kNeverReached, 1.0, 1.0}));
}

TEST(RankingGroups, LeaveOutScenesThatAreNotRanked) {
  const std::vector<Record> records = three_scenes();
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  const auto but_the_first = [](const std::string& scene) { return scene != "s1"; };
  const std::vector<RankingGroup> groups = ranking_groups(studies, but_the_first);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].scenes, (Names{"s2"}));
  EXPECT_EQ(groups[0].studies[0].size(), 1U);
  EXPECT_EQ(groups[1].scenes, (Names{"s3"}));
}

TEST(RankingGroups, KeepScenesThatNobodySolves) {
  std::vector<Record> records = three_scenes();
  for (const std::size_t i : {0U, 1U, 2U}) records[i].status = Status::timeout;
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  EXPECT_EQ(ranking_groups(studies, every_scene)[0].scenes, (Names{"s1", "s2"}));
}

}  // namespace
}  // namespace signorini::ranking_test
