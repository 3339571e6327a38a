#pragma once
// Runs joined into one, or one resumed by another, and whether they may be.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/run_folder/run_folder.hpp"

namespace signorini {

/// Why times and records of two runs cannot stand in one table, as "machine.cpu = ... (must be ... as in
/// ...)"; empty if they can: same machine, limits, build, suite and cases at a time, and of a plugin that
/// both used the same files.
std::optional<std::string> mixture(const RunFolder& a, const RunFolder& b);

/// How processor, number of processors or governor differ, in the same words.
std::optional<std::string> machine_difference(const RunFolder& a, const RunFolder& b);

/// How the files of a method's plugin that both runs used differ, in the same words. One that a single run
/// used is no difference.
std::optional<std::string> plugin_difference(const RunFolder& a, const RunFolder& b);

/// Adds to a manifest the hashes of plugins that only the other one has.
void join_plugins(nlohmann::ordered_json& manifest, const nlohmann::ordered_json& other);

/// All records once, in natural order of their names, each with the part that holds it; the plans joined; the
/// first manifest with the date, command line and load of each part, its times comparable where those of all
/// parts are. \throws UsageError if two of them do not
/// mix, or a shard is missing
RunFolder merge_runs(std::vector<RunFolder> parts);

/// Refuses to write over a run: an earlier merge, or runs put side by side, may be made again. \throws
/// UsageError
void require_no_run(const std::filesystem::path& out);

/// Refuses to go on with a run on another machine. \throws UsageError, one line that names the difference
void require_same_machine(const RunFolder& before, const RunFolder& now);

/// The plan of `now`, and of `before` the cases that it leaves out, as a narrower resumption does; not those
/// where limits, sources or a plugin that both use differ: their records are stale.
std::vector<PlannedCase> joined_plan(const RunFolder& before, const RunFolder& now);

}  // namespace signorini
