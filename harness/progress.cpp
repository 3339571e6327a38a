#include "harness/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace signorini {

std::string progress_line(std::size_t done, std::size_t total, double elapsed_seconds,
                          const std::string& what) {
  std::string eta;
  if (done > 0) {
    const auto left =
        std::lround(elapsed_seconds / static_cast<double>(done) * static_cast<double>(total - done));
    eta = fmt::format(" ETA {}:{:02}", left / 60, left % 60);
  }
  return fmt::format("[{}/{}] {} %{} {}", done, total, total == 0 ? 100 : 100 * done / total, eta, what);
}

Progress::Progress(std::size_t total) : total_(total), visible_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::begin(const std::string& what) {
  if (!visible_) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  // Cut to a usual terminal's width, or the carriage return would not reach the line's beginning.
  constexpr std::size_t kWidth = 79;
  fmt::print(stderr, "\r\033[K{}", progress_line(done_, total_, elapsed, what).substr(0, kWidth));
  std::fflush(stderr);
}

}  // namespace signorini
