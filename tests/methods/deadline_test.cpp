#include "methods/deadline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace signorini::deadline_test {
namespace {

using std::chrono::milliseconds;

/// Works until the processor clock of this process says so.
void work_for(double seconds) {
  const std::clock_t end = std::clock() + static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC);
  volatile double sum = 0.0;
  while (std::clock() < end) sum = sum + 1.0;
}

TEST(Deadline, IsOneOfProcessorTime) {
  const Deadline deadline = Deadline::after(0.05);
  EXPECT_LE(deadline.left(), 0.05);
  std::this_thread::sleep_for(milliseconds(80));
  EXPECT_FALSE(deadline.passed()) << "nothing has been done";
  work_for(0.06);
  EXPECT_TRUE(deadline.passed());
  EXPECT_LE(deadline.left(), 0.0);
}

TEST(Deadline, EndsWhatSleepsAtTheCeilingOfWallTime) {
  const Deadline deadline = Deadline::after(0.005);
  std::this_thread::sleep_for(milliseconds(60));
  EXPECT_TRUE(deadline.passed());
}

TEST(Deadline, OfWallTimeTakesNoNoticeOfWork) {
  const Deadline deadline = Deadline::after_wall(0.02);
  EXPECT_FALSE(Deadline::after_wall(60.0).passed());
  std::this_thread::sleep_for(milliseconds(30));
  EXPECT_TRUE(deadline.passed());
}

TEST(Deadline, MayBeEndless) {
  for (const Deadline& endless : {Deadline(), Deadline::max(), Deadline::after(1e300)}) {
    EXPECT_FALSE(endless.passed());
    EXPECT_GT(endless.left(), 1e12);
  }
  EXPECT_TRUE(Deadline::min().passed());
  EXPECT_TRUE(Deadline().endless());
}

TEST(Deadline, IsTheFirstOfTwo) {
  const Deadline late = Deadline::after(3600.0);
  EXPECT_TRUE(Deadline::first_of(late, Deadline::min()).passed());
  EXPECT_TRUE(Deadline::first_of(Deadline::min(), late).passed());
  const Deadline first = Deadline::first_of(late, Deadline());
  EXPECT_FALSE(first.passed());
  EXPECT_NEAR(first.left(), 3600.0, 60.0);
}

}  // namespace
}  // namespace signorini::deadline_test
