#pragma once
// Plans of a run that resumes another.

#include <vector>

#include "harness/records/run_folder.hpp"

namespace signorini {

/// Refuses to go on with a run on another machine. \throws UsageError, one line that names the difference
void require_same_machine(const RunFolder& before, const RunFolder& now);

/// The plan of `now`, and of `before` the cases that it leaves out, as a narrower resumption does; not those
/// where limits, sources or a plugin that both use differ: their records are stale.
std::vector<PlannedCase> joined_plan(const RunFolder& before, const RunFolder& now);

}  // namespace signorini
