#include "harness/plan/deadline.hpp"

#include <gtest/gtest.h>

namespace signorini::deadline_test {

namespace {

TEST(EnforcedLimit, LeavesAMethodTimeToEndByItself) {
  for (const double seconds : {0.001, 1.0, 30.0, 3600.0}) {
    EXPECT_GE(enforced(seconds), seconds + 0.2);
    EXPECT_LE(enforced(seconds), 1.1 * seconds + 0.5);
  }
}

}  // namespace

}  // namespace signorini::deadline_test
