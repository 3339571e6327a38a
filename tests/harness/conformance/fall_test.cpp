#include "harness/conformance/fall.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace {

std::vector<LadderStep> steps_of_order(double order) {
  std::vector<LadderStep> steps;
  for (const double size : {0.1, 0.05, 0.025})
    steps.push_back({.size = size, .error = 3.0 * std::pow(size, order)});
  return steps;
}

TEST(ObservedOrder, RecoversThePowerOfTheErrors) {
  for (const double order : {0.5, 1.0, 2.0, 7.0})
    EXPECT_NEAR(*observed_order(steps_of_order(order)), order, 1e-12);
  EXPECT_FALSE(observed_order({{.size = 0.1, .error = 1.0}}));
}

TEST(JudgeFall, AsksForTheDeclaredOrder) {
  EXPECT_EQ(judge_fall(steps_of_order(1.0), 1.0, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(judge_fall(steps_of_order(0.8), 1.0, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(judge_fall(steps_of_order(0.7), 1.0, 0.0).outcome, CheckOutcome::failed);
  EXPECT_EQ(judge_fall(steps_of_order(3.0), 1.0, 0.0).outcome, CheckOutcome::passed);
}

TEST(JudgeFall, AsksForHalfTheErrorWhereNoOrderIsDeclared) {
  EXPECT_EQ(judge_fall(steps_of_order(0.6), {}, 0.0).outcome, CheckOutcome::passed);
  EXPECT_EQ(judge_fall(steps_of_order(0.4), {}, 0.0).outcome, CheckOutcome::failed);
  EXPECT_EQ(judge_fall(steps_of_order(-1.0), {}, 0.0).outcome, CheckOutcome::failed);
}

TEST(JudgeFall, AsksNothingOfErrorsAtTheFloorAndTellsNothingFromOne) {
  EXPECT_EQ(judge_fall({{.size = 0.1, .error = 1e-12}, {.size = 0.05, .error = 2e-12}}, 4.0, 1e-11).outcome,
            CheckOutcome::passed);
  EXPECT_EQ(judge_fall({{.size = 0.1, .error = 1e-3}}, 4.0, 1e-11).outcome, CheckOutcome::not_applicable);
  EXPECT_EQ(judge_fall({}, 4.0, 1e-11).outcome, CheckOutcome::not_applicable);
}

TEST(BranchesOf, ALadderAreItsWordsWithStepsFromItsNumber) {
  const std::vector<LadderBranch> branches = branches_of({{{"flow", "a"}, {"samples", "10"}},
                                                          {{"flow", "a"}, {"samples", "40"}},
                                                          {{"flow", "b"}, {"samples", "10"}},
                                                          {{"flow", "b"}, {"samples", "40"}}});
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_EQ(branches[1].words, "flow=b");
  EXPECT_EQ(branches[1].places, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(branches[1].sizes, (std::vector<double>{0.1, 0.025}));
}

TEST(BranchesOf, TolerancesAreStepsThemselves) {
  const std::vector<LadderBranch> branches = branches_of({{{"tolerance", "1e-3"}}, {{"tolerance", "1e-6"}}});
  EXPECT_EQ(branches.front().sizes, (std::vector<double>{1e-3, 1e-6}));
}

}  // namespace
}  // namespace signorini
