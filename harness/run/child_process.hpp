#pragma once
// One forked child seen from the parent; used by isolation.cpp only.

#include <sys/types.h>

#include <chrono>
#include <string>

#include "harness/run/isolation.hpp"

namespace signorini {

class ChildProcess {
 public:
  /// Forks. \throws std::system_error
  ChildProcess(const IsolatedWork& work, const IsolationLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t id() const { return child_; }
  /// Descriptor to poll for input, -1 once the child has closed its end.
  [[nodiscard]] int descriptor() const { return pipe_; }
  /// Reads what there is, enforces the limits, collects a dead child. True once all is over.
  bool advance();
  /// Ends the child; `advance` then collects it.
  void interrupt();
  /// Valid once `advance` has returned true.
  [[nodiscard]] ChildEnd take_end() { return std::move(end_); }

 private:
  using Clock = std::chrono::steady_clock;

  void read_pipe();
  void take_line(std::string line);
  void enforce_deadline();
  void stop(ChildEnd::Kind reason);
  void collect();
  /// Wall and processor time for what comes until the next line.
  void begin_stage();

  IsolationLimits limits_;
  pid_t child_ = -1;
  int pipe_ = -1;
  int log_ = -1;
  std::string partial_;
  bool told_end_ = false;  // the child said how its work ended
  std::optional<ChildEnd::Kind> stopped_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point deadline_;
  double allowed_seconds_ = 0.0;  // of all stages so far
  ChildEnd end_;
};

}  // namespace signorini
