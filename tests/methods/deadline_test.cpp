#include "methods/deadline.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// What `work` in a child ends with.
template <typename Work>
int in_child(const Work& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

TEST(Deadline, CountsTheWorkOfChildren) {
  const Deadline deadline = Deadline::after(0.04);
  in_child([] {
    work_for(0.05);
    return 0;
  });
  EXPECT_TRUE(deadline.passed());
  EXPECT_FALSE(Deadline::after(60.0).passed());
}

TEST(Deadline, HoldsInAChild) {
  work_for(0.05);
  const Deadline deadline = Deadline::after(0.05);
  const double used = Deadline::processor_now();
  const auto ends_in_time = [&] {
    Deadline::go_on_from(used);
    return deadline.left() <= 0.05 ? 1 : 0;
  };
  EXPECT_EQ(in_child(ends_in_time), 1);
}

TEST(Deadline, EndsWhatSleepsAtTheCeilingOfWallTime) {
  const Deadline deadline = Deadline::after(0.005), of_two = Deadline::after(0.01, 2);
  std::this_thread::sleep_for(milliseconds(60));
  EXPECT_TRUE(deadline.passed());
  EXPECT_TRUE(of_two.passed());
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
