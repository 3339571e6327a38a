#include "harness/conformance/resolution_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::resolution_series_test {
namespace {

std::vector<ResolutionStep> steps_of_order(double order) {
  std::vector<ResolutionStep> steps;
  for (const double size : {0.1, 0.05, 0.025})
    steps.push_back({.size = size, .error = 3.0 * std::pow(size, order)});
  return steps;
}

TEST(ObservedOrder, RecoversThePowerOfTheErrors) {
  for (const double order : {0.5, 1.0, 2.0, 7.0})
    EXPECT_NEAR(*observed_order(steps_of_order(order)), order, 1e-12);
  EXPECT_FALSE(observed_order({{.size = 0.1, .error = 1.0}}));
}

TEST(CheckErrorDecay, AsksForTheDeclaredOrder) {
  EXPECT_EQ(check_error_decay(steps_of_order(1.0), 1.0, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(check_error_decay(steps_of_order(0.8), 1.0, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(check_error_decay(steps_of_order(0.7), 1.0, 0.0).outcome, CheckOutcome::failed);
  EXPECT_EQ(check_error_decay(steps_of_order(3.0), 1.0, 0.0).outcome, CheckOutcome::passed);
}

TEST(CheckErrorDecay, AsksForHalfTheErrorWhereNoOrderIsDeclared) {
  EXPECT_EQ(check_error_decay(steps_of_order(0.6), {}, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(check_error_decay(steps_of_order(0.4), {}, 0.0).outcome, CheckOutcome::failed);
  EXPECT_EQ(check_error_decay(steps_of_order(-1.0), {}, 0.0).outcome, CheckOutcome::failed);
}

TEST(CheckErrorDecay, AsksNothingOfErrorsAtTheFloorAndTellsNothingFromOne) {
  EXPECT_EQ(
      check_error_decay({{.size = 0.1, .error = 1e-12}, {.size = 0.05, .error = 2e-12}}, 4.0, 1e-11).outcome,
      CheckOutcome::passed);
  EXPECT_EQ(check_error_decay({{.size = 0.1, .error = 1e-3}}, 4.0, 1e-11).outcome,
            CheckOutcome::not_applicable);
  EXPECT_EQ(check_error_decay({}, 4.0, 1e-11).outcome, CheckOutcome::not_applicable);
}

TEST(ResolutionSeries, DifferInWordsAndTheirStepsInANumber) {
  const std::vector<ResolutionSeries> series = resolution_series({{{"flow", "a"}, {"samples", "10"}},
                                                                  {{"flow", "a"}, {"samples", "40"}},
                                                                  {{"flow", "b"}, {"samples", "10"}},
                                                                  {{"flow", "b"}, {"samples", "40"}}});
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[1].words, "flow=b");
  EXPECT_EQ(series[1].places, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(series[1].sizes, (std::vector<double>{0.1, 0.025}));
}

TEST(ResolutionSeries, HaveTolerancesAsSizes) {
  const std::vector<ResolutionSeries> series =
      resolution_series({{{"tolerance", "1e-3"}}, {{"tolerance", "1e-6"}}});
  EXPECT_EQ(series.front().sizes, (std::vector<double>{1e-3, 1e-6}));
}

}  // namespace
}  // namespace signorini::resolution_series_test
