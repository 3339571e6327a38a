#pragma once
// Points in time at which work has to end.

#include <chrono>

namespace signorini {

using Deadline = std::chrono::steady_clock::time_point;

/// So many seconds, which need not be whole, from now. \param seconds  >= 0 [s]
inline Deadline deadline_after(double seconds) {
  return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                std::chrono::duration<double>(seconds));
}

/// Applicability and law, measures, the end of a process: quick unless something hangs [s].
inline constexpr double kQuickSeconds = 10.0;

/// When a process is ended whose method was asked to keep a limit: a method that does so ends by itself, and
/// its own message is better than that of a process killed. \param seconds  the limit [s]
inline double enforced(double seconds) {
  constexpr double kShare = 1.05, kConstant = 0.2;
  return seconds * kShare + kConstant;
}

}  // namespace signorini
