#include "harness/records/run_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <unordered_map>
#include <unordered_set>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/manifest_check.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_store.hpp"
#include "problems/scene/toml_tree.hpp"

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
      throw UsageError(fmt::format("{}: case = {} (must be a key and a name, at most {} bytes)",
                                   file.string(), one_line(line), kLongestText));
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

}  // namespace

void visit_fields(Either<Limits> auto& limits, auto&& field) {
  field(required("timeout_s", "s"), limits.timeout);
  field(required("memory_mb", "MiB"), limits.memory_mb);
  field(required("repetitions"), limits.repetitions);
  field(required("certificate_timeout_s", "s"), limits.certificate_timeout);
  field(required("reference_timeout_s", "s"), limits.reference_timeout);
}

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
  run.manifest = read_manifest(folder / "manifest.json");
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

Limits limits_of_run(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  Limits limits;
  if (!fs::exists(file)) return limits;
  const Json manifest = read_manifest(file);
  try {
    read_fields(manifest.at("limits"), limits);
    return limits;
  } catch (const nlohmann::json::exception&) {
    throw UsageError(
        fmt::format("{}: limits = unreadable (must be a manifest that run wrote)", file.string()));
  }
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
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"command_line", words},
          {"build", build()},
          {"machine", machine()}};
}

Json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                   const std::vector<std::string>& command_line) {
  const Json program = program_manifest(command_line);
  return {{"schema", program["schema"]},
          {"suite", suite.name},
          {"date", program["date"]},
          {"command_line", program["command_line"]},
          {"order", "scene by scene, rounds in random order"},
          {"seed", schedule.seed},
          {"jobs", schedule.together()},
          {"times_comparable", build_may_be_timed() && schedule.together() == 1},
          {"limits", write_fields(limits)},
          {"build", program["build"]},
          {"machine", program["machine"]}};
}

}  // namespace signorini
