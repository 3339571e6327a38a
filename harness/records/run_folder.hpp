#pragma once
// The folder of a run: manifest.json, the build, machine and limits that records come from; plan.txt; and
// records.jsonl.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// A case that a run is to have a record of.
struct PlannedCase {
  std::string key = {};
  std::string case_id = {};
  std::string method = {};
};

struct RunFolder {
  std::filesystem::path path = {};
  nlohmann::ordered_json manifest = {};
  std::vector<PlannedCase> plan = {};  ///< empty for runs of before there was a plan.txt
  std::vector<Record> records = {};    ///< those that count
  std::vector<Record> stale = {};      ///< left over from other code, limits, options or scenes
};

/// Moves to `stale` what does not count: records of no case of the plan; where there is no plan, all but the
/// last of each case.
void set_stale_aside(RunFolder& run);

/// \throws UsageError if it is no folder that a run wrote, or a file of it is unreadable
RunFolder read_run(const std::filesystem::path& folder);

/// Records of a folder that count; a manifest is not asked for. \throws UsageError if a file is unreadable
std::vector<Record> read_current_records(const std::filesystem::path& folder);

/// DIR/plan.txt: one case per line, key and name. \throws UsageError if the folder cannot be written
void write_plan(const std::filesystem::path& folder, const std::vector<PlannedCase>& plan);

/// What every manifest says: schema, date, command line, build and machine. What the system does not tell is
/// absent.
nlohmann::ordered_json program_manifest(const std::vector<std::string>& command_line);

/// Build, machine, date, limits and command line. What the system does not tell is absent.
nlohmann::ordered_json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                                     const std::vector<std::string>& command_line);

/// Limits of the run that left `folder`, from its manifest; the defaults where there is none.
/// \throws UsageError if it is unreadable
Limits limits_of_run(const std::filesystem::path& folder);

/// The run's name: that of its folder.
std::string run_name(const std::filesystem::path& folder);

/// Governor of the first processor's clock, as the system's files below `root` say; empty where they do not.
std::string clock_governor(const std::filesystem::path& root = "/");

}  // namespace signorini
