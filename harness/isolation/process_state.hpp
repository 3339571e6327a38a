#pragma once
// What is of a whole process: what a method can change for everything that comes after it, and threads.

#include <array>
#include <cfenv>
#include <csignal>
#include <string>

namespace signorini {

/// Rounding to nearest, and numbers below the smallest normal one kept: what every result here is computed
/// with.
bool floating_point_is_usual();

/// Has OpenMP and the linear algebra libraries that the program is linked to (OpenBLAS, MKL) compute on the
/// thread that calls them from now on, and by the environment those that plugins load later: times are of one
/// core, whatever BLAS is installed, and a forked child does not wait for threads that its parent had.
void compute_on_one_thread();

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
