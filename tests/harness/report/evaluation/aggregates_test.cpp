#include "harness/report/evaluation/aggregates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace signorini {
namespace {

constexpr double kFails = std::numeric_limits<double>::infinity();

TEST(ShiftedGeometricMean, IsTheGeometricMeanWithoutAShift) {
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{1.0, 100.0}, 0.0, 0.0), 10.0, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{2.0, 2.0, 2.0}, 5.0, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(shifted_geometric_mean(std::vector<double>{1.0, 7.0}, 1.0, 0.0), 3.0, 1e-12);
}

TEST(ShiftedGeometricMean, DependsOnItsShiftWhichMustThereforeBeSaid) {
  // Milliseconds on most scenes against seconds on some: the shift decides who wins.
  const std::vector<double> mostly_fast{0.001, 0.001, 0.001, 8.0};
  const std::vector<double> even{0.2, 0.2, 0.2, 0.2};
  const auto ratio = [&](double shift) {
    return shifted_geometric_mean(mostly_fast, shift, 0.0) / shifted_geometric_mean(even, shift, 0.0);
  };
  EXPECT_LT(ratio(0.0), 0.1);
  EXPECT_LT(ratio(kMeanShift), 0.5);
  EXPECT_GT(ratio(1.0), 1.0);
  EXPECT_GT(ratio(10.0), 1.0);
}

TEST(Aggregates, DoNotRewardFragility) {
  // Three of eight in 2 s on average against eight of eight in 27 s: the mean over survivors misleads.
  const std::vector<double> fragile{1.0, 2.0, 3.0, kFails, kFails, kFails, kFails, kFails};
  const std::vector<double> robust{4.0, 6.0, 8.0, 12.0, 20.0, 30.0, 50.0, 86.0};
  EXPECT_EQ(solved_count(fragile), 3U);
  EXPECT_EQ(solved_count(robust), 8U);
  EXPECT_GT(shifted_geometric_mean(fragile, 1.0, 100.0), shifted_geometric_mean(robust, 1.0, 100.0));
  EXPECT_GT(par2(fragile, 100.0), 4.0 * par2(robust, 100.0));
}

TEST(Par2, ChargesAFailureTwiceTheLimit) {
  EXPECT_DOUBLE_EQ(par2(std::vector<double>{1.0, kFails}, 10.0), 10.5);
}

}  // namespace
}  // namespace signorini
