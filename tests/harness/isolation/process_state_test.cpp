#include "harness/isolation/process_state.hpp"

#include <gtest/gtest.h>

#include <limits>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace signorini::process_state_test {
namespace {

TEST(ProcessState, SaysThatNothingHasChanged) {
  EXPECT_TRUE(floating_point_is_usual());
  const ProcessState usual;
  volatile double one = 1.0;
  one = one / 3.0;  // sets the flag of inexact results, which is no change
  EXPECT_EQ(usual.restore(), "");
}

TEST(ProcessState, RestoresTheRoundingOfNumbers) {
  const ProcessState usual;
  std::fesetround(FE_UPWARD);
  EXPECT_FALSE(floating_point_is_usual());
  EXPECT_EQ(usual.restore(), "the rounding of numbers");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
#if defined(__x86_64__)
  constexpr unsigned kFlushToZero = 0x8000U;
  _mm_setcsr(_mm_getcsr() | kFlushToZero);
  EXPECT_FALSE(floating_point_is_usual());
  EXPECT_EQ(usual.restore(), "the rounding of numbers");
#endif
  EXPECT_TRUE(floating_point_is_usual());
}

TEST(ProcessState, RestoresSignalHandlers) {
  const auto before = std::signal(SIGUSR1, SIG_DFL);
  const ProcessState usual;
  std::signal(SIGUSR1, SIG_IGN);
  std::signal(SIGSEGV, SIG_IGN);
  EXPECT_EQ(usual.restore(), "signal handlers");
  EXPECT_EQ(std::signal(SIGUSR1, before), SIG_DFL);
  EXPECT_EQ(usual.restore(), "");
}

}  // namespace
}  // namespace signorini::process_state_test
