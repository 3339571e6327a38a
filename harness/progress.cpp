#include "harness/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace signorini {

std::string progress_line(double done, std::size_t total, double elapsed_seconds, const std::string& what) {
  constexpr double kRounding = 1e-6;  // of shares of cases that add up
  const auto all = static_cast<double>(total);
  std::string eta;
  if (done > kRounding) {
    const auto left = std::lround(elapsed_seconds / done * std::max(0.0, all - done));
    eta = fmt::format(" ETA {}:{:02}", left / 60, left % 60);
  }
  const double percent = total == 0 ? 100.0 : 100.0 * done / all;
  return fmt::format("[{:.0f}/{}] {:.0f} %{} {}", std::floor(done + kRounding), total,
                     std::floor(percent + kRounding), eta, what);
}

Progress::Progress(std::size_t total) : total_(total), visible_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::clear() const {
  if (!visible_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

void Progress::begin(const std::string& what) {
  if (!visible_) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  // Cut to the width of a terminal: a carriage return goes back to the beginning of the last line only.
  constexpr std::size_t kWidth = 79;
  fmt::print(stderr, "\r\033[K{}", progress_line(done_, total_, elapsed, what).substr(0, kWidth));
  std::fflush(stderr);
}

}  // namespace signorini
