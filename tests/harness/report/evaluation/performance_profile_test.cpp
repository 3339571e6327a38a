#include "harness/report/evaluation/performance_profile.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace signorini {
namespace {

constexpr double kFails = std::numeric_limits<double>::infinity();

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

TEST(PairwiseProfile, RanksTheTwoThatAJointProfileGetsWrong) {
  // Gould and Scott: beside A, B looks better than C; without A, C is better than B on five of eight.
  const Costs costs{{1.0, 1.0, 1.0, 1.0, 9.0, 9.0, 9.0, 9.0},
                    {4.0, 4.0, 4.0, 4.0, 1.0, 1.0, 1.0, 4.0},
                    {2.0, 2.0, 2.0, 2.0, 8.0, 8.0, 8.0, 1.0}};
  const PerformanceProfile joint = performance_profile(costs);
  EXPECT_DOUBLE_EQ(joint.share(1, 1.0), 3.0 / 8.0);
  EXPECT_DOUBLE_EQ(joint.share(2, 1.0), 1.0 / 8.0);
  const PerformanceProfile pair = pairwise_profile(costs, 1, 2);
  EXPECT_DOUBLE_EQ(pair.share(0, 1.0), 3.0 / 8.0);
  EXPECT_DOUBLE_EQ(pair.share(1, 1.0), 5.0 / 8.0);
}

TEST(PairwiseProfile, CountsTiesForBoth) {
  const PerformanceProfile pair = pairwise_profile({{1.0, kFails}, {1.0, kFails}}, 0, 1);
  EXPECT_DOUBLE_EQ(pair.share(0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(pair.share(1, 1.0), 0.5);
}

}  // namespace
}  // namespace signorini
