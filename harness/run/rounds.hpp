#pragma once
// The cases of one scene, their rounds of timing interleaved.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/plan/schedule.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

/// Told of what happens; `index` is that of the job.
struct RoundEvents {
  std::function<void(const std::string& what)> begin = {};
  std::function<void(std::size_t index, const Record& record)> unfinished = {};  ///< rounds are missing yet
  std::function<void(std::size_t index, const Record& record)> complete = {};
};

/// Runs every job, round by round in the order of a Latin square: the first round solves, measures and
/// certifies, the later ones only time. A case that fails leaves. \param begun  what an earlier, interrupted
/// run left of each job, if anything \return false if interrupted
bool run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                std::vector<std::optional<Record>> begun, const Schedule& schedule,
                const RoundEvents& events);

}  // namespace signorini
