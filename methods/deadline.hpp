#pragma once
// The end of a time budget: processor time, which a busy machine does not change, and a ceiling of wall time.

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace signorini {

/// When work has to end. A budget is processor time of this process and of the children that it has waited
/// for, so that what comes of the work does not depend on what else the machine does; of wall time it may
/// take kWallPerProcessor times as much, for what sleeps or waits. A deadline holds in a child too, which
/// goes on from the time of its parent (`go_on_from`).
class Deadline {
 public:
  using Clock = std::chrono::steady_clock;  ///< of wall time
  /// Wall time that a budget of processor time may take, over that budget [-]
  static constexpr double kWallPerProcessor = 10.0;

  /// Never passes.
  Deadline() = default;
  /// Passes at an instant, however much or little work that leaves: the end of somebody's patience.
  Deadline(Clock::time_point instant) : earliest_(instant), latest_(instant) {}  // NOLINT(*-explicit-*)
  /// After so many seconds of work, which need not be whole. \param seconds  >= 0 [s] \param processes  of
  /// this program that work at a time, the seconds of all of them counted together
  static Deadline after(double seconds, int processes = 1) {
    Deadline deadline(instant_after(kWallPerProcessor * seconds / processes));
    deadline.earliest_ = instant_after(seconds / processes);
    deadline.processor_ = processor_now() + seconds;
    return deadline;
  }
  /// At an instant so many seconds of wall time from now. \param seconds  >= 0 [s]
  static Deadline after_wall(double seconds) { return instant_after(seconds); }
  static Deadline max() { return {}; }                   ///< never passes
  static Deadline min() { return Clock::time_point{}; }  ///< has passed

  /// Whether the work has to end.
  [[nodiscard]] bool passed() const {
    if (earliest_ == Clock::time_point::max()) return false;
    // A thread has no more processor time than has passed: its clock, which is slow, is asked only then.
    const Clock::time_point now = Clock::now();
    return now > earliest_ && (now > latest_ || processor_now() > processor_);
  }
  [[nodiscard]] bool endless() const { return earliest_ == Clock::time_point::max(); }  ///< it never passes
  /// Work left, negative once it has passed, infinite if it never does [s].
  [[nodiscard]] double left() const {
    if (endless()) return std::numeric_limits<double>::infinity();
    const std::chrono::duration<double> wall = latest_ - Clock::now();
    return std::min(processor_ - processor_now(), wall.count());
  }
  /// The deadline that passes when one of two does.
  static Deadline first_of(const Deadline& a, const Deadline& b) {
    Deadline first(std::min(a.latest_, b.latest_));
    first.earliest_ = std::min(a.earliest_, b.earliest_);
    first.processor_ = std::min(a.processor_, b.processor_);
    return first;
  }
  /// Processor time of this process, of its children that have ended, and of its parents before them [s].
  static double processor_now() {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return inherited + static_cast<double>(std::clock()) / CLOCKS_PER_SEC + seconds(children.ru_utime) +
           seconds(children.ru_stime);
  }
  /// In a child, whose clock begins anew. \param processor  `processor_now` of the parent before it [s]
  static void go_on_from(double processor) { inherited = processor; }

 private:
  static Clock::time_point instant_after(double seconds) {
    const std::chrono::duration<double> most = Clock::time_point::max() - Clock::now();
    if (seconds >= 0.5 * most.count()) return Clock::time_point::max();
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }

  Clock::time_point earliest_ = Clock::time_point::max();  // it passes at neither clock before that
  Clock::time_point latest_ = Clock::time_point::max();
  double processor_ = std::numeric_limits<double>::infinity();  // `processor_now` [s]
  inline static double inherited = 0.0;                         // of the parents [s]
};

}  // namespace signorini
