#include "harness/run_folder/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "harness/commands/command_line.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct NamedStatus {
  std::string name;
  RunStatus status;
};

/// The status of the folder if a run or a merge wrote it, else of each shard in it and of all together.
std::vector<NamedStatus> read_statuses(const fs::path& folder) {
  std::vector<NamedStatus> statuses;
  if (!fs::exists(folder / "manifest.json") && fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!fs::exists(entry.path() / "manifest.json") || !fs::exists(entry.path() / "records.jsonl"))
        continue;
      const RunFolder run = read_run(entry.path());
      const bool merged = run.manifest.contains("shards");  // holds what the shards beside it hold
      if (!merged) statuses.push_back({entry.path().filename().string(), status_of(run)});
    }
  }
  if (statuses.empty()) return {{folder.string(), status_of(read_run(folder))}};
  std::ranges::sort(statuses, natural_less, &NamedStatus::name);
  std::vector<RunStatus> parts;
  for (const NamedStatus& one : statuses) parts.push_back(one.status);
  statuses.push_back({"all", together(parts)});
  return statuses;
}

std::string rest_text(const RunStatus& status) {
  if (status.pending == 0) return "done";
  const std::string state = status.running ? "running" : "stopped";
  if (!status.remaining_seconds) return state;
  const auto left = std::lround(*status.remaining_seconds);
  return fmt::format("{}, {}:{:02} of work left", state, left / 60, left % 60);
}

Json to_json(const NamedStatus& one) {
  const RunStatus& s = one.status;
  Json json{{"name", one.name},
            {"planned", s.planned},
            {"converged", s.converged},
            {"inaccurate", s.inaccurate},
            {"not_applicable", s.not_applicable},
            {"failed", s.failed},
            {"pending", s.pending},
            {"stale", s.stale},
            {"running", s.running}};
  if (s.remaining_seconds) json["remaining_s"] = *s.remaining_seconds;
  json["failures"] = Json::array();
  for (const Failure& failure : s.failures) json["failures"].push_back(failure.case_id);
  return json;
}

void print_table(const std::vector<NamedStatus>& statuses) {
  Table table{
      {"run", "planned", "converged", "inaccurate", "not applicable", "failed", "pending", "stale", "state"},
      {}};
  for (const auto& [name, s] : statuses) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{name});
    for (const std::size_t count :
         {s.planned, s.converged, s.inaccurate, s.not_applicable, s.failed, s.pending, s.stale})
      row.emplace_back(std::to_string(count));
    row.emplace_back(rest_text(s));
  }
  fmt::print("{}", to_columns(table, kTerminalWidth));
  for (const Failure& failure : statuses.back().status.failures)
    fmt::print("{}: {}\n", status_name(failure.status), failure.case_id);
}

struct StatusArguments {
  std::string folder;
  bool json = false;
};

void status(const StatusArguments& arguments) {
  const std::vector<NamedStatus> statuses = read_statuses(arguments.folder);
  if (!arguments.json) return print_table(statuses);
  Json list = Json::array();
  for (const NamedStatus& one : statuses) list.push_back(to_json(one));
  fmt::print("{}\n", json_text(list));
}

}  // namespace

void add_status_command(const Command& program) {
  const auto [command, arguments] =
      program.command("status", status,
                      "How far a run has come: cases done, failed and pending, and the time that the "
                      "rest will take. Of a folder of shards: each of them, and all.");
  command.option("dir", arguments->folder, "folder of a run, or of shards", {.required = true});
  command.flag("--json", arguments->json, "print a JSON array, the sum last");
}

}  // namespace signorini
