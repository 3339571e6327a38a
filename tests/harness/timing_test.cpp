#include "harness/timing.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "harness/statistics.hpp"

namespace signorini {
namespace {

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3.0}), 3.0);
  EXPECT_EQ(median({9.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 2.0, 9.0}), 3.0);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1.0, infinity, infinity, infinity}), infinity);
  EXPECT_EQ(median({1.0, 2.0, infinity}), 2.0);
}

TEST(MedianDeviation, IgnoresOneOutlier) {
  EXPECT_EQ(median_deviation({1.0, 2.0, 3.0, 1000.0, 2.0}), 1.0);
  EXPECT_EQ(median_deviation({5.0}), 0.0);
}

TEST(TimeRounds, KeepsTheLeastTimeOfEachRound) {
  int calls = 0;
  const auto timed = [&] {
    ++calls;
    return calls % 5 == 0 ? 1e-4 : 1e-3;  // pretended, so that the outcome does not depend on this machine
  };
  const std::vector<double> rounds = time_rounds("test", timed, 1e-3, {.rounds = 4, .round_seconds = 0.01});
  ASSERT_EQ(rounds.size(), 4U);
  for (const double least : rounds) EXPECT_NEAR(least, 1e-4, 1e-12);
  EXPECT_GE(calls, 20);
}

TEST(TimeRounds, CallsSlowWorkOnceARoundAndCountsTheFirstCall) {
  int calls = 0;
  const auto timed = [&] {
    ++calls;
    return 1.0;
  };
  EXPECT_EQ(time_rounds("test", timed, 2.0, {.rounds = 3, .round_seconds = 0.01, .total_seconds = 100.0}),
            (std::vector<double>{2.0, 1.0, 1.0}));
  EXPECT_EQ(calls, 2);
}

TEST(TimeRounds, GivesVerySlowWorkFewerRounds) {
  int calls = 0;
  const auto timed = [&] {
    ++calls;
    return 60.0;
  };
  EXPECT_EQ(time_rounds("test", timed, 60.0, {.rounds = 5, .round_seconds = 0.01, .total_seconds = 5.0}),
            (std::vector<double>{60.0}));
  EXPECT_EQ(calls, 0);
}

TEST(Summarise, AddsSetUpAndSolveRoundByRound) {
  const Seconds seconds = summarise({1.0, 2.0, 3.0}, {10.0, 10.0, 20.0});
  EXPECT_EQ(seconds.median, 12.0);
  EXPECT_EQ(seconds.min, 11.0);
  EXPECT_EQ(seconds.mad, 1.0);
  EXPECT_EQ(seconds.setup, 2.0);
  EXPECT_EQ(seconds.solve, 10.0);
  EXPECT_EQ(seconds.repetitions, 3);
}

}  // namespace
}  // namespace signorini
