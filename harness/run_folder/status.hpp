#pragma once
// How many cases of a run are done, and how long the rest will take.

#include <optional>

#include "harness/run_folder/run_folder.hpp"

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
  /// Expected time of the pending cases [s], see Durations; empty if nothing is known.
  std::optional<double> remaining_seconds = {};
};

RunStatus status_of(const RunFolder& run);

/// The status of runs side by side: sums of the counts, running if one of them is, and the longest of the
/// remaining times.
RunStatus together(const std::vector<RunStatus>& parts);

}  // namespace signorini
