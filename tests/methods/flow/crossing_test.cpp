#include <gtest/gtest.h>

#include <cmath>

#include "methods/flow/stretch.hpp"

namespace signorini::crossing_test {
namespace {

std::function<Guard(double)> parabola(double a, double b, double c) {
  return [=](double t) { return Guard{.value = a * t * t + b * t + c, .rate = 2.0 * a * t + b}; };
}

TEST(FirstCrossing, FindsASimpleRootToRoundOff) {
  const auto guard = [](double t) { return Guard{.value = std::cos(t), .rate = -std::sin(t)}; };
  const auto time = first_crossing(guard, {.begin = 1.0, .end = 2.0});
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, std::acos(0.0), 1e-15 * 2.0);
}

TEST(FirstCrossing, SeesAnExcursionBelowZeroThatReturnsInsideTheStep) {
  // (t - 0.4)(t - 0.45): positive at both ends and at the middle of [0, 1].
  const auto time = first_crossing(parabola(1.0, -0.85, 0.18), {.begin = 0.0, .end = 1.0});
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, 0.4, 1e-14);
}

TEST(FirstCrossing, IgnoresATouchThatStaysAboveZero) {
  EXPECT_FALSE(first_crossing(parabola(1.0, -0.8, 0.16 + 1e-12), {.begin = 0.0, .end = 1.0}));
}

TEST(FirstCrossing, DoesNotReportAGuardThatStartsAtZeroAndRises) {
  EXPECT_FALSE(
      first_crossing(parabola(0.0, 1.0, 0.0), {.begin = 0.0, .end = 1.0, .fresh = true, .floor = 1e-12}));
  // Round-off below zero at the start makes no difference.
  EXPECT_FALSE(
      first_crossing(parabola(0.0, 1.0, -1e-17), {.begin = 0.0, .end = 1.0, .fresh = true, .floor = 1e-12}));
}

TEST(FirstCrossing, FindsTheReturnOfAReboundShorterThanTheStep) {
  // Flight t (0.3 - t): up and down again before the middle of the step.
  const auto time =
      first_crossing(parabola(-1.0, 0.3, 0.0), {.begin = 0.0, .end = 1.0, .fresh = true, .floor = 1e-12});
  ASSERT_TRUE(time);
  EXPECT_NEAR(*time, 0.3, 1e-14);
}

TEST(FirstCrossing, ToleratesNoiseBelowTheFloorOfAFreshGuardOnly) {
  const auto sinking = parabola(0.0, -1e-14, 0.0);
  EXPECT_FALSE(first_crossing(sinking, {.begin = 0.0, .end = 1.0, .fresh = true, .floor = 1e-12}));
  const auto deeper =
      first_crossing(parabola(0.0, -1e-11, 0.0), {.begin = 0.0, .end = 1.0, .fresh = true, .floor = 1e-12});
  ASSERT_TRUE(deeper);
  EXPECT_NEAR(*deeper, 0.1, 1e-10);
}

}  // namespace
}  // namespace signorini::crossing_test
