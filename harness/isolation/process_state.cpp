#include "harness/isolation/process_state.hpp"

#include <cstddef>
#include <limits>

namespace signorini {

namespace {

/// What is called; std::signal changes the flags, which nobody misses.
bool same_handler(const struct sigaction& a, const struct sigaction& b) {
  return a.sa_handler == b.sa_handler;
}

}  // namespace

bool floating_point_is_usual() {
  const volatile double smallest = std::numeric_limits<double>::min();
  return std::fegetround() == FE_TONEAREST && smallest / 2.0 > 0.0;
}

ProcessState::ProcessState() {
  std::fegetenv(&floating_point_);
  for (int signal = 1; signal < kSignals; ++signal)
    sigaction(signal, nullptr, &handlers_[static_cast<std::size_t>(signal)]);
}

std::string ProcessState::restore() const {
  const bool rounding = !floating_point_is_usual();
  std::fesetenv(&floating_point_);
  bool handlers = false;
  for (int signal = 1; signal < kSignals; ++signal) {
    const struct sigaction& before = handlers_[static_cast<std::size_t>(signal)];
    struct sigaction now {};
    // The system refuses to tell or set those of SIGKILL and SIGSTOP, which nobody can change.
    if (sigaction(signal, nullptr, &now) != 0 || same_handler(now, before)) continue;
    handlers = sigaction(signal, &before, nullptr) == 0 || handlers;
  }
  const std::string numbers = rounding ? "the rounding of numbers" : "";
  if (!handlers) return numbers;
  return numbers.empty() ? "signal handlers" : numbers + " and signal handlers";
}

}  // namespace signorini
