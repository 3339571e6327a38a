#include "harness/plan/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace signorini {
namespace {

using Order = std::vector<std::size_t>;

TEST(RoundOrder, HasEveryCaseOnce) {
  Order order = round_order(30, 1, "sdof-stop", 0);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(order[i], i);
  EXPECT_TRUE(round_order(0, 1, "sdof-stop", 0).empty());
}

TEST(RoundOrder, IsAnotherForAnotherSeedSceneOrRound) {
  const Order order = round_order(20, 1, "sdof-stop", 0);
  EXPECT_EQ(round_order(20, 1, "sdof-stop", 0), order);
  EXPECT_NE(round_order(20, 2, "sdof-stop", 0), order);
  EXPECT_NE(round_order(20, 1, "beam-stop", 0), order);
  EXPECT_NE(round_order(20, 1, "sdof-stop", 1), order);
}

TEST(RoundOrder, PutsEachCaseAtEachPlaceAboutEquallyOften) {
  constexpr std::size_t kCount = 4;
  constexpr int kRounds = 4000;
  std::vector<std::vector<int>> times(kCount, std::vector<int>(kCount, 0));
  for (int round = 0; round < kRounds; ++round) {
    const Order order = round_order(kCount, 1, "sdof-stop", round);
    for (std::size_t place = 0; place < kCount; ++place) ++times[order[place]][place];
  }
  // A thousand expected with a standard deviation of 27.4: five of them either way.
  for (const std::vector<int>& row : times) {
    for (const int count : row) EXPECT_NEAR(count, 1000, 137);
  }
}

// Literal rows: with this library a run of today and one of tomorrow take the same order.
#ifdef __GLIBCXX__
TEST(RoundOrder, IsTheSameInEveryProcess) {
  EXPECT_EQ(round_order(6, 1, "sdof-stop", 0), (Order{1, 0, 2, 5, 4, 3}));
  EXPECT_EQ(round_order(6, 1, "sdof-stop", 1), (Order{1, 4, 3, 0, 5, 2}));
}
#endif

TEST(Schedule, CountsTheCasesOfAllRunsOnThisMachine) {
  EXPECT_EQ(Schedule{}.together(), 1);
  EXPECT_EQ((Schedule{.parallel = 2, .beside = 3}.together()), 6);
}

}  // namespace
}  // namespace signorini
