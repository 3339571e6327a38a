#include "harness/interrupt.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace signorini::interrupt_test {
namespace {

/// Ends the process with 0 if a signal only raised the flag.
void take_signal(int signal) {
  watch_interrupts();
  const bool before = interrupted();
  std::raise(signal);
  std::exit(!before && interrupted() ? 0 : 1);
}

// In processes of their own: the flag stays up.
TEST(InterruptDeathTest, IsAFlagThatSignalsRaise) {
  EXPECT_FALSE(interrupted());
  EXPECT_EXIT(take_signal(SIGINT), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(take_signal(SIGTERM), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace signorini::interrupt_test
