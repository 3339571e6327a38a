// A clock of the day that jumps an hour to and fro with each look, for LD_PRELOAD: somebody sets it while the
// program runs. The clock that only goes on is left alone.

#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

// NOLINTNEXTLINE(readability-identifier-naming): the function that it stands before
extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
  static int looks = 0;
  constexpr time_t kJump = 3600;  // [s]
  const int failure = static_cast<int>(syscall(SYS_clock_gettime, clock, now));
  if (failure == 0 && clock == CLOCK_REALTIME) now->tv_sec += ++looks % 2 == 0 ? kJump : -kJump;
  return failure;
}
