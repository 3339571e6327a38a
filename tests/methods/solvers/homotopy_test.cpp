#include "methods/solvers/homotopy.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace signorini::homotopy_test {
namespace {

bool never() { return false; }

/// A path from 0 to 1 on which no step may be longer than `follows`.
struct Path {
  double follows = 1.0;
  double here = 0.0;
  std::vector<double> tried = {};

  bool to_the_end(const PathSteps& steps) {
    return follow_path(
        steps,
        [this](double step) {
          tried.push_back(step);
          if (step > follows) return false;
          here += step;
          return true;
        },
        [this] { return here >= 1.0; }, never);
  }
};

TEST(FollowPath, HalvesAStepThatFailsAndGrowsAfterOneThatIsTaken) {
  Path path{.follows = 0.3};
  EXPECT_TRUE(path.to_the_end({}));
  EXPECT_EQ(path.tried, (std::vector<double>{1.0, 0.5, 0.25, 0.5, 0.25, 0.5, 0.25, 0.5, 0.25}));
}

TEST(FollowPath, TakesNoStepAboveTheLargest) {
  Path path;
  EXPECT_TRUE(path.to_the_end({.first = 0.25, .largest = 0.375, .growth = 4.0}));
  EXPECT_EQ(path.tried, (std::vector<double>{0.25, 0.375, 0.375}));
}

TEST(FollowPath, GivesUpBelowTheSmallestStepOrAfterTooManyTrials) {
  Path lost{.follows = 0.0};
  EXPECT_FALSE(lost.to_the_end({.smallest = 0.25}));
  EXPECT_EQ(lost.tried, (std::vector<double>{1.0, 0.5, 0.25}));
  Path slow{.follows = 0.125};
  EXPECT_FALSE(slow.to_the_end({.first = 0.125, .largest = 0.125, .trials = 5}));
  EXPECT_EQ(slow.tried.size(), 5U);
}

TEST(FollowPath, TriesNothingAtTheEndOrWhenStopped) {
  Path there{.here = 1.0};
  EXPECT_TRUE(there.to_the_end({}));
  EXPECT_TRUE(there.tried.empty());
  int trials = 0;
  const auto advance = [&](double) { return ++trials > 0; };
  EXPECT_FALSE(follow_path({}, advance, never, [&] { return trials == 2; }));
  EXPECT_EQ(trials, 2);
}

}  // namespace
}  // namespace signorini::homotopy_test
