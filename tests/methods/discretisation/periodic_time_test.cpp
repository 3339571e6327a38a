#include "methods/discretisation/periodic_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::periodic_time_test {
namespace {

TEST(WrappedTime, DiffersFromTheTimeByWholePeriodsAndLiesWithinOne) {
  constexpr double kPeriod = 0.75;
  for (int k = -400; k <= 400; ++k) {
    const double time = 0.0137 * k;
    const double wrapped = wrapped_time(time, kPeriod);
    EXPECT_GE(wrapped, 0.0);
    EXPECT_LT(wrapped, kPeriod);
    const double periods = (time - wrapped) / kPeriod;
    EXPECT_NEAR(periods, std::round(periods), 1e-12);
  }
}

TEST(WrappedTime, LeavesAnInstantWithinThePeriodAlone) {
  EXPECT_EQ(wrapped_time(0.0, 2.0), 0.0);
  EXPECT_EQ(wrapped_time(1.75, 2.0), 1.75);
  EXPECT_EQ(wrapped_time(2.0, 2.0), 0.0);
}

TEST(WrappedTime, NeverIsThePeriodItself) {
  // -1e-20 + 1 rounds to 1.
  EXPECT_EQ(wrapped_time(-1e-20, 1.0), 0.0);
}

}  // namespace
}  // namespace signorini::periodic_time_test
