#include "harness/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

namespace signorini {

namespace {

/// A line that is longer than the terminal is wide wraps, and a carriage return goes back to the beginning of
/// its last part only.
std::size_t line_width() {
  winsize size{};
  const bool told = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return told ? std::min<std::size_t>(kLineWidth, size.ws_col - 1U) : kLineWidth;
}

constexpr std::string_view kClearLine = "\r\033[K";

/// Nothing depends on its arrival.
void write_to_terminal(std::string_view text) {
  static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
}

}  // namespace

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
  fmt::print(stderr, "{}", kClearLine);
  std::fflush(stderr);
}

void Progress::begin(const std::string& what) {
  if (!visible_) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  fmt::print(stderr, "{}{}", kClearLine, progress_line(done_, total_, elapsed, what).substr(0, line_width()));
  std::fflush(stderr);
}

std::string waiting_line(const std::string& what, std::chrono::seconds elapsed, std::size_t width) {
  const auto seconds = elapsed.count();
  const std::string clock = fmt::format(" {}:{:02}", seconds / 60, seconds % 60);
  return what.substr(0, width - std::min(width, clock.size())) + clock;
}

Waiting::Waiting(std::string what) : what_(std::move(what)) {
  if (isatty(STDERR_FILENO) != 1) return;
  try {
    teller_ = std::thread([this] { tell(); });
  } catch (const std::system_error&) {  // the machine allows no further thread: nobody is told
  }
}

Waiting::~Waiting() {
  if (!teller_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  teller_.join();
}

void Waiting::tell() {
  using namespace std::chrono_literals;
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  bool told = false;
  for (auto next = start + 500ms; !ended_.wait_until(lock, next, [this] { return done_; }); told = true) {
    const auto elapsed = std::chrono::round<std::chrono::seconds>(next - start);
    write_to_terminal(std::string(kClearLine) + waiting_line(what_, elapsed, line_width()));
    next = start + elapsed + 1s;
  }
  if (told) write_to_terminal(kClearLine);
}

}  // namespace signorini
