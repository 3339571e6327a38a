#include "methods/continuation/interval_gaps.hpp"

#include <gtest/gtest.h>

namespace signorini::interval_gaps_test {
namespace {

TEST(Uncovered, AreThePartsOfTheIntervalThatNoRangeHolds) {
  const std::vector<ParameterRange> held{{2.0, 2.5}, {1.0, 1.4}, {2.4, 3.0}, {7.0, 8.0}};
  const std::vector<ParameterRange> gaps = uncovered(held, 1.0, 4.0);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].low, 1.4);
  EXPECT_EQ(gaps[0].high, 2.0);
  EXPECT_EQ(gaps[1].low, 3.0);
  EXPECT_EQ(gaps[1].high, 4.0);
  EXPECT_EQ(uncovered(held, 4.0, 1.0).size(), 2U);
  EXPECT_TRUE(uncovered({{0.5, 9.0}}, 1.0, 4.0).empty());
  EXPECT_TRUE(uncovered({{1.0, 2.0}, {2.0 + 1e-7, 4.0}}, 1.0, 4.0).empty());
  EXPECT_EQ(uncovered({}, 1.0, 4.0).size(), 1U);
}

}  // namespace
}  // namespace signorini::interval_gaps_test
