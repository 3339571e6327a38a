#include "harness/plan/deadline.hpp"

#include <gtest/gtest.h>

namespace signorini::deadline_test {

namespace {

TEST(DeadlineAfter, LiesThatManySecondsAhead) {
  const auto before = std::chrono::steady_clock::now();
  const Deadline deadline = deadline_after(2.5);
  const auto after = std::chrono::steady_clock::now();
  EXPECT_GE(deadline - before, std::chrono::milliseconds(2500));
  EXPECT_LE(deadline - after, std::chrono::milliseconds(2500));
}

TEST(EnforcedLimit, LeavesAMethodTimeToEndByItself) {
  for (const double seconds : {0.001, 1.0, 30.0, 3600.0}) {
    EXPECT_GE(enforced(seconds), seconds + 0.2);
    EXPECT_LE(enforced(seconds), 1.1 * seconds + 0.5);
  }
}

}  // namespace

}  // namespace signorini::deadline_test
