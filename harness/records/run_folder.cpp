#include "harness/records/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_store.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

std::vector<PlannedCase> read_plan(const fs::path& file) {
  std::vector<PlannedCase> plan;
  std::istringstream lines(read_file(file));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos)
      throw UsageError(fmt::format("{}: case = {} (must be a key and a name)", file.string(), line));
    const std::string name = line.substr(space + 1);
    plan.push_back({.key = line.substr(0, space), .case_id = name, .method = parse_case_name(name).method});
  }
  return plan;
}

void read_plan_and_records(RunFolder& run) {
  if (fs::exists(run.path / "plan.txt")) run.plan = read_plan(run.path / "plan.txt");
  run.records = read_records(run.path / "records.jsonl");
  set_stale_aside(run);
}

std::unordered_set<std::string> keys_that_count(const RunFolder& run) {
  std::unordered_set<std::string> keys;
  for (const PlannedCase& one : run.plan) keys.insert(one.key);
  if (!keys.empty()) return keys;
  std::unordered_map<std::string, std::string> last;  // by case
  for (const Record& record : run.records) last[record.case_id] = record.key;
  for (const auto& [case_id, key] : last) keys.insert(key);
  return keys;
}

/// Checks the types of the entries that commands compute with.
void check_types(const nlohmann::ordered_json& manifest, const fs::path& file) {
  const auto check = [&](const char* field, bool (*is_right)(const nlohmann::ordered_json&),
                         const char* requirement) {
    if (!manifest.contains(field) || is_right(manifest[field])) return;
    throw UsageError(
        fmt::format("{}: {} = {} (must be {})", file.string(), field, manifest[field].dump(), requirement));
  };
  check(
      "jobs", [](const auto& value) { return value.is_number(); }, "a number");
  check(
      "times_comparable", [](const auto& value) { return value.is_boolean(); }, "true or false");
  check(
      "machine", [](const auto& value) { return value.is_object(); }, "an object");
}

}  // namespace

void set_stale_aside(RunFolder& run) {
  const std::unordered_set<std::string> keys = keys_that_count(run);
  const auto counts = [&](const Record& record) { return keys.contains(record.key); };
  const auto stale = std::stable_partition(run.records.begin(), run.records.end(), counts);
  run.stale.insert(run.stale.end(), std::move_iterator(stale), std::move_iterator(run.records.end()));
  run.records.erase(stale, run.records.end());
}

RunFolder read_run(const fs::path& folder) {
  if (!fs::exists(folder / "manifest.json") || !fs::exists(folder / "records.jsonl")) {
    throw UsageError(
        fmt::format("dir = {} (must be a folder with manifest.json and records.jsonl, as run writes it)",
                    folder.string()));
  }
  RunFolder run{.path = folder};
  run.manifest = nlohmann::ordered_json::parse(read_file(folder / "manifest.json"), nullptr, false);
  if (!run.manifest.is_object()) {
    throw UsageError(fmt::format("{}: manifest = unreadable (must be one JSON object)",
                                 (folder / "manifest.json").string()));
  }
  check_types(run.manifest, folder / "manifest.json");
  read_plan_and_records(run);
  return run;
}

std::vector<Record> read_current_records(const fs::path& folder) {
  RunFolder run{.path = folder};
  read_plan_and_records(run);
  return std::move(run.records);
}

void write_plan(const fs::path& folder, const std::vector<PlannedCase>& plan) {
  std::string text;
  for (const PlannedCase& one : plan) text += fmt::format("{} {}\n", one.key, one.case_id);
  write_whole(folder / "plan.txt", text);
}

}  // namespace signorini
