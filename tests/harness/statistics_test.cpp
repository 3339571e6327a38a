#include "harness/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace signorini::statistics_test {
namespace {

TEST(Median, IsTheMiddleOfASortedSample) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const std::size_t size : {1U, 2U, 7U, 100U}) {
    std::vector<double> values(size);
    for (double& value : values) value = uniform(random);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(median(values), 0.5 * (sorted[(size - 1) / 2] + sorted[size / 2])) << size;
  }
}

TEST(Median, TakesFailuresAsInfiniteTimes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1.0, kInfinity, 2.0}), 2.0);
  EXPECT_EQ(median({1.0, kInfinity}), kInfinity);
  EXPECT_EQ(median({kInfinity, kInfinity}), kInfinity) << "the mean of two infinite values is none";
}

TEST(MedianDeviation, IsHalfTheSpreadOfThreeEquidistantValuesAndIgnoresAnOutlier) {
  EXPECT_EQ(median_deviation({1.0, 2.0, 3.0}), 1.0);
  EXPECT_EQ(median_deviation({5.0}), 0.0);
  EXPECT_EQ(median_deviation({1.0, 2.0, 3.0, 4.0, 1e9}), 1.0);
}

TEST(MedianDeviation, OfANormalSampleIsThatOfTheDistribution) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(3.0, 2.0);
  std::vector<double> values(20001);
  for (double& value : values) value = normal(random);
  // 0.67449 standard deviations; the standard error of the estimate is 1.17 / sqrt(n) of it.
  EXPECT_NEAR(median_deviation(values), 2.0 * 0.67449, 4.0 * 2.0 * 0.67449 * 1.17 / std::sqrt(20001.0));
}

}  // namespace
}  // namespace signorini::statistics_test
