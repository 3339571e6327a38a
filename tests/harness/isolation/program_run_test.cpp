// Programs of the machine that are run for what they print.

#include <gtest/gtest.h>

#include <cstddef>

#include "harness/isolation/child_process.hpp"

namespace signorini::program_run_test {
namespace {

TEST(ProgramRun, GivesOutputAndExitCode) {
  const ProgramEnd end = run_to_end({"sh", "-c", "cat; printf 'a\\nb'; exit 3"});  // cat finds no input
  EXPECT_EQ(end.output, "a\nb");
  EXPECT_EQ(end.code, 3);
  EXPECT_FALSE(end.missing());
  EXPECT_EQ(run_to_end({"sh", "-c", "kill -9 $$"}).code, -1);
}

TEST(ProgramRun, SaysThatThereIsNoSuchProgram) {
  EXPECT_TRUE(run_to_end({"signorini-no-such-program"}).missing());
}

TEST(ProgramRun, EndsOneThatPrintsWithoutEnd) {
  constexpr std::size_t kMost = 1000000;
  EXPECT_GT(run_to_end({"yes"}, kMost).output.size(), kMost);
}

}  // namespace
}  // namespace signorini::program_run_test
