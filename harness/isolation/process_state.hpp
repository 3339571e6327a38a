#pragma once
// What a method can change for everything that comes after it in its process.

#include <array>
#include <cfenv>
#include <csignal>
#include <string>

namespace signorini {

/// Rounding to nearest, and numbers below the smallest normal one kept: what every result here is computed
/// with.
bool floating_point_is_usual();

/// The floating-point environment and the signal handlers at one moment.
class ProcessState {
 public:
  /// Those of now.
  ProcessState();
  /// Makes them what they were. \return what had been changed, "the rounding of numbers", "signal handlers"
  /// or both; empty where nothing was
  [[nodiscard]] std::string restore() const;

 private:
  static constexpr int kSignals = 32;  // those that POSIX names

  std::fenv_t floating_point_ = {};
  std::array<struct sigaction, kSignals> handlers_ = {};
};

}  // namespace signorini
