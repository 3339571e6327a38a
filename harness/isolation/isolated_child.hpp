#pragma once
// One child process that runs a piece of work under limits and sends lines to its parent.

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/isolation/child_end.hpp"
#include "harness/isolation/child_process.hpp"
#include "harness/plan/deadline.hpp"

namespace signorini {

/// What a child may use.
struct IsolationLimits {
  /// Wall time until each line that the child sends [s]; the last one holds for all later lines and the end.
  /// The same limits hold for processor time since its start, plus one second: enough for one thread.
  std::vector<double> stage_seconds{30.0};
  double grace = 0.5;               ///< from SIGTERM to SIGKILL [s]
  std::optional<long> memory_mb{};  ///< address space [MiB]; not enforced under the address sanitizer
};

/// The child's way to its parent.
class LineSender {
 public:
  explicit LineSender(int pipe) : pipe_(pipe) {}
  /// Hands one line to the parent at once; line breaks in it become blanks.
  void operator()(std::string_view line) const;

 private:
  int pipe_;
};

using IsolatedWork = std::function<void(const LineSender& send)>;

class IsolatedChild {
 public:
  /// Forks. \throws std::system_error
  IsolatedChild(const IsolatedWork& work, const IsolationLimits& limits);

  [[nodiscard]] pid_t id() const { return process_.id(); }
  /// Descriptors to poll: one is readable when `advance` has something to do. -1: none.
  [[nodiscard]] int line_descriptor() const { return pipe_.read.number(); }
  [[nodiscard]] int end_descriptor() const { return process_.end_descriptor(); }
  /// Reads the lines that have arrived, enforces the limits, collects a dead child. True once it has ended.
  bool advance();
  /// Asks the child to end; `advance` then collects it.
  void interrupt();
  /// Valid once `advance` has returned true.
  [[nodiscard]] ChildEnd take_end() { return std::move(end_); }

 private:
  void read_lines();
  void take_line(std::string_view line);
  void enforce_deadline();
  void stop(ChildEnd::Kind reason);
  void collect();
  /// Sets the limits of wall and processor time for what comes until the next line.
  void begin_stage();

  IsolationLimits limits_;
  Pipe pipe_;
  Descriptor log_;  ///< stdout and stderr of the child, a file in memory
  ChildProcess process_;
  std::string partial_line_;
  bool work_ended_ = false;  ///< the child reported how its work ended
  std::optional<ChildEnd::Kind> stopped_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Deadline deadline_;
  double allowed_seconds_ = 0.0;  ///< of all stages so far
  ChildEnd end_;
};

}  // namespace signorini
