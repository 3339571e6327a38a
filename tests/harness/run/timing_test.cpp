#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "harness/run/trial.hpp"

namespace signorini::timing_test {
namespace {

TEST(TimeRound, KeepsTheLeastTimeOfTheRound) {
  int calls = 0;
  const auto timed = [&] {
    ++calls;
    return calls % 5 == 0 ? 1e-4 : 1e-3;  // pretended, so that the outcome does not depend on this machine
  };
  EXPECT_NEAR(time_round(timed, 1e-3, {.round_seconds = 0.01}), 1e-4, 1e-12);
  EXPECT_GE(calls, 10);
}

/// How often a round calls work whose times are these, the last one from then on.
int calls_of_round(const std::vector<double>& times) {
  std::size_t calls = 0;
  time_round([&] { return times[std::min(calls++, times.size() - 1)]; }, 1e-3, {.round_seconds = 0.01});
  return static_cast<int>(calls);
}

TEST(TimeRound, EndsWhereTheTwoLeastTimesAgree) {
  EXPECT_EQ(calls_of_round({5e-4}), 5);
  EXPECT_EQ(calls_of_round({5e-4, 5.04e-4, 1e-3, 1e-3, 1e-3}), 5) << "whatever the others took";
  EXPECT_EQ(calls_of_round({8e-4, 7e-4, 6e-4, 5e-4, 4e-4, 3e-4}), 7) << "not while they still fall";
  EXPECT_EQ(calls_of_round({1e-5}), 100) << "a tenth of the round at least";
  EXPECT_EQ(calls_of_round({1e-3, 0.9e-3, 0.8e-3, 0.7e-3, 0.6e-3, 0.5e-3, 6.0e-3}), 7) << "its time is over";
}

TEST(TimeRound, CountsAFirstCallThatFillsTheRound) {
  int calls = 0;
  const auto timed = [&] {
    ++calls;
    return 1.0;
  };
  EXPECT_EQ(time_round(timed, 2.0, {.round_seconds = 0.01}), 2.0);
  EXPECT_EQ(calls, 0);
}

TEST(TimeRound, IsNotMisledByAFirstCallThatWasInterrupted) {
  EXPECT_NEAR(time_round([] { return 1e-3; }, 0.015, {.round_seconds = 0.01}), 1e-3, 1e-12);
  EXPECT_EQ(time_round([] { return 0.02; }, 0.03, {.round_seconds = 0.01}), 0.02);
}

TEST(RoundsFor, GivesSlowWorkFewerRoundsButNeverNone) {
  const TimingBudget budget{.rounds = 5, .round_seconds = 0.01, .total_seconds = 5.0};
  EXPECT_EQ(rounds_for(1e-6, budget), 5);
  EXPECT_EQ(rounds_for(0.5, budget), 5);
  EXPECT_EQ(rounds_for(2.0, budget), 2);
  EXPECT_EQ(rounds_for(60.0, budget), 1);
}

std::vector<TimedRound> rounds_of(const std::vector<double>& seconds) {
  std::vector<TimedRound> rounds;
  for (const double one : seconds) rounds.push_back({.setup = 0.25 * one, .solve = 0.75 * one});
  return rounds;
}

TEST(RoundsMissing, AreThosePlannedAndMoreWhileTimesDifferByAQuarter) {
  constexpr int kMore = 3;
  EXPECT_EQ(rounds_missing(rounds_of({1.0}), 3, kMore), 2);
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 1.2, 1.1}), 3, kMore), 0);
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 1.55, 1.1}), 3, kMore), 1);
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 1.55, 1.1, 1.2}), 3, kMore), 0) << "three agree";
  EXPECT_EQ(rounds_missing(rounds_of({2.32, 3.59}), 2, kMore), 1);
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 2.0, 4.0, 8.0}), 2, kMore), 1);
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 2.0, 4.0, 8.0, 16.0}), 2, kMore), 0) << "enough is enough";
  EXPECT_FALSE(rounds_agree(rounds_of({1.0, 2.0, 4.0, 8.0, 16.0}), 2));
  EXPECT_EQ(rounds_missing(rounds_of({1.0, 2.0}), 2, 0), 0);
  EXPECT_EQ(rounds_missing(rounds_of({1.0}), 1, kMore), 0) << "one round has nothing to differ from";
}

TEST(Summarise, AddsSetUpAndSolveRoundByRound) {
  const Seconds seconds = summarise({{1.0, 10.0}, {2.0, 10.0}, {3.0, 20.0}});
  EXPECT_EQ(seconds.median, 12.0);
  EXPECT_EQ(seconds.min, 11.0);
  EXPECT_EQ(seconds.mad, 1.0);
  EXPECT_EQ(seconds.setup, 2.0);
  EXPECT_EQ(seconds.solve, 10.0);
  EXPECT_EQ(seconds.repetitions, 3);
  EXPECT_EQ(seconds.rounds.size(), 3U);
  EXPECT_FALSE(seconds.first.has_value());
}

TEST(Summarise, KeepsTheFirstTimesApart) {
  EXPECT_EQ(summarise({{1.0, 2.0, 9.0}, {1.0, 2.0}, {1.0, 2.0, 5.0}, {1.0, 2.0, 8.0}}).first, 8.0);
}

TEST(Summarise, CallsTimesUnstableThatDeviateByMoreThanFivePercent) {
  EXPECT_EQ(summarise({{0.0, 1.0}, {0.0, 1.04}, {0.0, 0.96}}).unstable, false);
  EXPECT_EQ(summarise({{0.0, 1.0}, {0.0, 1.06}, {0.0, 0.94}}).unstable, true);
  EXPECT_FALSE(summarise({{0.0, 1.0}}).unstable.has_value());  // one round knows nothing of deviations
}

}  // namespace
}  // namespace signorini::timing_test
