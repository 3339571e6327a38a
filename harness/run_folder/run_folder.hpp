#pragma once
// The folder of a run: manifest.json, the build, machine and limits that records come from; plan.txt; and
// records.jsonl.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/run_folder/record_store.hpp"

namespace signorini {

/// A case that a run is to have a record of.
struct PlannedCase {
  std::string key = {};
  std::string case_id = {};
  std::string method = {};
};

/// A run without the contents of its records: some 300 bytes of each, so that runs of millions are read.
struct RunFolder {
  std::filesystem::path path = {};
  nlohmann::ordered_json manifest = {};
  std::vector<PlannedCase> plan = {};     ///< empty for runs of before there was a plan.txt
  std::vector<RecordEntry> records = {};  ///< those that count
  std::vector<RecordEntry> stale = {};    ///< left over from other code, limits, options or scenes
};

/// Takes each record of a file as it is read, in the order of RecordEntry::ordinal.
using RecordObserver = std::function<void(Record)>;

/// Moves to `stale` what does not count: records of no case of the plan; where there is no plan, all but the
/// last of each case.
void set_stale_aside(RunFolder& run);

/// Manifest and plan of a run, without any record. \throws UsageError if it is no folder that a run wrote, or
/// a file of it is unreadable
RunFolder read_description(const std::filesystem::path& folder);

/// A run, of several records with one key the last. \throws UsageError if it is no folder that a run wrote,
/// or a file of it is unreadable
RunFolder read_run(const std::filesystem::path& folder);

/// The entries of a folder and its plan, of one pass over its records; a manifest is not asked for.
/// \throws UsageError if a file is unreadable
RunFolder read_entries(const std::filesystem::path& folder, const RecordObserver& observe);

/// Records of a folder that count, whole and all in memory; a manifest is not asked for. \throws UsageError
/// if a file is unreadable
std::vector<Record> read_current_records(const std::filesystem::path& folder);

/// DIR/plan.txt: one case per line, key and name. \throws UsageError if the folder cannot be written
void write_plan(const std::filesystem::path& folder, const std::vector<PlannedCase>& plan);

/// What every manifest says: schema, date, command line, build and machine. What the system does not tell is
/// absent.
nlohmann::ordered_json program_manifest(const std::vector<std::string>& command_line);

/// Build, machine, date, limits, command line and whether times are comparable (note_times), as far as that
/// is known at the start. What the system does not tell is absent.
nlohmann::ordered_json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                                     const std::vector<std::string>& command_line);

/// Limits of the run that left `folder`, from its manifest; the defaults where there is none.
/// \throws UsageError if it is unreadable
Limits limits_of_run(const std::filesystem::path& folder);

/// Refuses a folder with the responses.jsonl of an earlier version and no records. \throws UsageError that
/// says how they are made anew
void refuse_old_responses(const std::filesystem::path& folder);

/// The run's name: that of its folder.
std::string run_name(const std::filesystem::path& folder);

/// Governor of the first processor's clock, as the system's files below `root` say; empty where they do not.
std::string clock_governor(const std::filesystem::path& root = "/");

}  // namespace signorini
