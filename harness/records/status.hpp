#pragma once

#include <optional>

#include "harness/records/run_folder.hpp"

namespace signorini {

/// A case that did not converge.
struct Failure {
  std::string case_id = {};
  Status status = Status::inaccurate;
};

/// How far a run has come.
struct RunStatus {
  std::size_t planned = 0;
  std::size_t converged = 0, inaccurate = 0, not_applicable = 0;
  std::size_t failed = 0;              ///< any other status
  std::size_t pending = 0;             ///< planned, without a record
  std::size_t stale = 0;               ///< records of other code, limits, options or scenes than the plan's
  std::vector<Failure> failures = {};  ///< failed and inaccurate cases
  bool running = false;                ///< a process works on it
  /// What pending cases are expected to take [s], by their own time in a record of before, their method's
  /// mean or the mean of all; empty if nothing is known.
  std::optional<double> remaining_seconds = {};
};

RunStatus status_of(const RunFolder& run);

/// Sums; running if one of them is, and then the rest is what the slowest needs, for they run side by side.
RunStatus together(const std::vector<RunStatus>& parts);

}  // namespace signorini
