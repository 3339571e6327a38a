#pragma once
// Time budgets of the harness.

#include "methods/deadline.hpp"

namespace signorini {

/// Applicability and law, measures, the end of a process: quick unless something hangs [s].
inline constexpr double kQuickSeconds = 10.0;

/// When a process is ended whose method was asked to keep a limit: a method that does so ends by itself, and
/// its own message is better than that of a process killed. \param seconds  the limit [s]
inline double enforced(double seconds) {
  constexpr double kShare = 1.05, kConstant = 0.2;
  return seconds * kShare + kConstant;
}

}  // namespace signorini
