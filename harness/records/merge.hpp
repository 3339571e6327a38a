#pragma once
// Runs joined into one, and whether they may be.

#include <optional>
#include <span>
#include <string>

#include "harness/records/run_folder.hpp"

namespace signorini {

/// Why times and records of two runs cannot stand in one table, as "machine.cpu = ... (must be ... as in
/// ...)"; empty if they can: same machine, limits, build, suite and cases at a time, and of a plugin that
/// both used the same files.
std::optional<std::string> mixture(const RunFolder& a, const RunFolder& b);

/// Same processor, number of processors and governor.
bool same_machine(const RunFolder& a, const RunFolder& b);

/// How the machines differ, in the same words.
std::optional<std::string> machine_difference(const RunFolder& a, const RunFolder& b);

/// How the files of a method's plugin that both runs used differ, in the same words. One that a single run
/// used is no difference.
std::optional<std::string> plugin_difference(const RunFolder& a, const RunFolder& b);

/// Adds to a manifest the hashes of plugins that only the other one has.
void join_plugins(nlohmann::ordered_json& manifest, const nlohmann::ordered_json& other);

/// All records once, in natural order of their names; the plans joined; the first manifest with the date,
/// command line and load of each part. \throws UsageError if two of them do
/// not mix, or a shard is missing
RunFolder merge_runs(std::span<const RunFolder> parts);

}  // namespace signorini
