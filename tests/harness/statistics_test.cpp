#include "harness/statistics.hpp"

#include <gtest/gtest.h>

#include <limits>

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

}  // namespace
}  // namespace signorini
