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

}  // namespace signorini
