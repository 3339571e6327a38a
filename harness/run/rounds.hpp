#pragma once
// The cases of one scene, their rounds of timing interleaved.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/plan/schedule.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

/// Follows the cases of a scene through their rounds; `index` is that of the job.
class RoundObserver {
 public:
  virtual ~RoundObserver() = default;
  /// \param what  the case, or the round of several, for a person
  virtual void begins(const std::string& what) { static_cast<void>(what); }
  /// The record lacks rounds of timing yet.
  virtual void round_done(std::size_t index, const Record& record) {
    static_cast<void>(index), static_cast<void>(record);
  }
  virtual void case_done(std::size_t index, const Record& record) = 0;
};

/// Runs every job, round by round in random order: the first round solves, measures and certifies, the later
/// ones only time. A case that fails has no later rounds. \param begun  what an earlier, interrupted run left
/// of each job, if anything \return false if interrupted
bool run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                std::vector<std::optional<Record>> begun, const Schedule& schedule, RoundObserver& observer);

}  // namespace signorini
