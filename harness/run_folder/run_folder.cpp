#include "harness/run_folder/run_folder.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <unordered_set>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<PlannedCase> read_plan(const fs::path& file) {
  std::vector<PlannedCase> plan;
  std::istringstream lines(read_file(file));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos || line.size() > kLongestText || has_control_characters(line))
      throw UsageError("{}: case = {} (must be a key and a name, at most {} bytes)", file.string(),
                       one_line(line), kLongestText);
    const std::string name = line.substr(space + 1);
    plan.push_back({.key = line.substr(0, space), .case_id = name, .method = parse_case_name(name).method});
  }
  return plan;
}

/// \throws UsageError if it is no folder that a run wrote
Json manifest_of(const fs::path& folder) {
  refuse_old_responses(folder);
  if (!fs::exists(folder / "manifest.json") || !fs::exists(folder / "records.jsonl")) {
    throw UsageError("dir = {} (must be a folder with manifest.json and records.jsonl, as run writes it)",
                     folder.string());
  }
  return read_manifest(folder / "manifest.json");
}

/// Of several entries with one key the last, where the first stood; those without a key are nobody's, and
/// stay.
std::vector<RecordEntry> last_of_each_key(std::vector<RecordEntry> entries) {
  std::vector<std::size_t> kept;
  std::unordered_map<std::string_view, std::size_t> places;  // of keys in `kept`
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto [place, fresh] = places.try_emplace(entries[i].key, kept.size());
    if (fresh || entries[i].key.empty())
      kept.push_back(i);
    else
      kept[place->second] = i;
  }
  if (kept.size() == entries.size()) return entries;
  std::vector<RecordEntry> last;
  for (const std::size_t i : kept) last.push_back(std::move(entries[i]));
  return last;
}

/// Keys of a run's plan; where there is none, those of the last record of each case.
std::unordered_set<std::string_view> keys_that_count(const RunFolder& run) {
  std::unordered_set<std::string_view> keys;
  for (const PlannedCase& one : run.plan) keys.insert(one.key);
  if (!keys.empty()) return keys;
  std::unordered_map<std::string_view, std::string_view> last;  // by case
  for (const RecordEntry& record : run.records) last[record.case_id] = record.key;
  for (const auto& [case_id, key] : last) keys.insert(key);
  return keys;
}

std::string kernel_release() {
  utsname names{};
  return uname(&names) == 0 ? names.release : "";
}

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

Json machine() {
  Json json = Json::object();
  write_field(json, Field{"cpu"}, cpu_model());
  json["processors"] = std::thread::hardware_concurrency();
  write_field(json, Field{"governor"}, clock_governor());
  write_field(json, Field{"kernel"}, kernel_release());
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) == 3) json["load"] = load;
  if (const auto now = load_average()) json["running"] = now->running;
  return json;
}

Json build() {
  const BuildInfo& info = build_info();
  Json json{{"version", info.version}};
  if (!info.commit.empty()) {
    json["commit"] = info.commit;
    json["dirty"] = info.dirty;
  }
  json["compiler"] = info.compiler;
  json["flags"] = info.flags;
  json["build_type"] = info.build_type;
  json["timings_count"] = build_may_be_timed();
  json["libraries"] = Json::object();
  for (const auto& [name, version] : info.libraries)
    write_field(json["libraries"], Field{std::string(name).c_str()}, std::string(version));
  json["sources"] = Json::object();
  for (const auto& [name, hash] : info.sources)
    json["sources"][name.empty() ? "common" : std::string(name)] = hash;
  return json;
}

/// "2026-03-01T12:00:00Z".
std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::array<char, 24> text{};
  gmtime_r(&now, &utc);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace

void visit_fields(Either<Limits> auto& limits, auto&& field) {
  field(required("timeout_s", "s"), limits.timeout);
  field(required("memory_mb", "MiB"), limits.memory_mb);
  field(required("repetitions"), limits.repetitions);
  field(required("certificate_timeout_s", "s"), limits.certificate_timeout);
  field(required("reference_timeout_s", "s"), limits.reference_timeout);
}

void set_stale_aside(RunFolder& run) {
  std::vector<RecordEntry> current, stale;
  std::vector<bool> counts;
  {
    const std::unordered_set<std::string_view> keys = keys_that_count(run);  // into what is moved below
    for (const RecordEntry& record : run.records) counts.push_back(keys.contains(record.key));
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    (counts[i] ? current : stale).push_back(std::move(run.records[i]));
  run.records = std::move(current);
  std::ranges::move(stale, std::back_inserter(run.stale));
}

RunFolder read_description(const fs::path& folder) {
  RunFolder run{.path = folder, .manifest = manifest_of(folder)};
  if (fs::exists(folder / "plan.txt")) run.plan = read_plan(folder / "plan.txt");
  return run;
}

RunFolder read_run(const fs::path& folder) {
  Json manifest = manifest_of(folder);
  RunFolder run = read_entries(folder, [](const Record&) {});
  run.manifest = std::move(manifest);
  return run;
}

RunFolder read_entries(const fs::path& folder, const RecordObserver& observe) {
  RunFolder run{.path = folder};
  if (fs::exists(folder / "plan.txt")) run.plan = read_plan(folder / "plan.txt");
  std::vector<RecordEntry> entries;
  for_each_record(folder / "records.jsonl", [&](Record record, const LinePlace& place) {
    entries.push_back(entry_of(record, place, entries.size()));
    observe(std::move(record));
  });
  run.records = last_of_each_key(std::move(entries));
  set_stale_aside(run);
  return run;
}

std::vector<Record> read_current_records(const fs::path& folder) {
  std::vector<Record> all, current;
  const RunFolder run = read_entries(folder, [&](Record record) { all.push_back(std::move(record)); });
  for (const RecordEntry& entry : run.records) current.push_back(std::move(all[entry.ordinal]));
  return current;
}

void write_plan(const fs::path& folder, const std::vector<PlannedCase>& plan) {
  std::string text;
  for (const PlannedCase& one : plan) text += fmt::format("{} {}\n", one.key, one.case_id);
  write_whole(folder / "plan.txt", text);
}

Limits limits_of_run(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  Limits limits;
  if (!fs::exists(file)) return limits;
  const Json manifest = read_manifest(file);
  try {
    read_fields(manifest.at("limits"), limits);
    return limits;
  } catch (const nlohmann::json::exception&) {
    throw UsageError("{}: limits = unreadable (must be a manifest that run wrote)", file.string());
  }
}

void refuse_old_responses(const fs::path& folder) {
  if (fs::exists(folder / "records.jsonl") || !fs::exists(folder / "responses.jsonl")) return;
  throw UsageError(
      "dir = {} (must hold records.jsonl, not responses.jsonl of an earlier version: `run` makes them anew)",
      folder.string());
}

std::string run_name(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::string clock_governor(const fs::path& root) {
  return first_line(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
}

Json program_manifest(const std::vector<std::string>& command_line) {
  // A folder may have any name; a manifest holds it as a reader will take it.
  std::vector<std::string> words;
  std::ranges::transform(command_line, std::back_inserter(words), as_message);
  return {{"schema", 1},
          {"date", utc_now()},
          {"command_line", words},
          {"build", build()},
          {"machine", machine()}};
}

Json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                   const std::vector<std::string>& command_line) {
  const Json program = program_manifest(command_line);
  Json manifest{{"schema", program["schema"]},
                {"suite", suite.name},
                {"date", program["date"]},
                {"command_line", program["command_line"]},
                {"order", "scene by scene, rounds in random order"},
                {"seed", schedule.seed},
                {"jobs", schedule.together()},
                {"times_comparable", true},
                {"limits", write_fields(limits)},
                {"build", program["build"]},
                {"machine", program["machine"]}};
  note_times(manifest);
  return manifest;
}

}  // namespace signorini
