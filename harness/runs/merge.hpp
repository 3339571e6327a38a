#pragma once

#include <optional>
#include <span>
#include <string>

#include "harness/runs/run_folder.hpp"

namespace signorini {

/// Why times and records of two runs cannot stand in one table, as "machine.cpu = ... (must be ... as in
/// ...)"; empty if they can: same machine, limits, build, suite and cases at a time.
std::optional<std::string> mixture(const RunFolder& a, const RunFolder& b);

/// Same processor, number of processors and governor.
bool same_machine(const RunFolder& a, const RunFolder& b);

/// How the machines differ, in the same words.
std::optional<std::string> machine_difference(const RunFolder& a, const RunFolder& b);

/// All records once, in natural order of their names; the plans joined; the first manifest with the date,
/// command line and load of each part. \throws UsageError if two of them do
/// not mix, or a shard is missing
RunFolder merge_runs(std::span<const RunFolder> parts);

}  // namespace signorini
