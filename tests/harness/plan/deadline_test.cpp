#include "harness/plan/deadline.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(DeadlineAfter, LiesThatManySecondsAhead) {
  const auto before = std::chrono::steady_clock::now();
  const Deadline deadline = deadline_after(2.5);
  const auto after = std::chrono::steady_clock::now();
  EXPECT_GE(deadline - before, std::chrono::milliseconds(2500));
  EXPECT_LE(deadline - after, std::chrono::milliseconds(2500));
}

}  // namespace
}  // namespace signorini
