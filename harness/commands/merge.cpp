#include "harness/run_folder/merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <span>

#include "harness/commands/command_line.hpp"
#include "harness/files.hpp"
#include "harness/records/line_file.hpp"
#include "harness/report/report.hpp"
#include "harness/run_folder/status.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Manifest, plan and records of a merge; the lines of records as they stand in its parts.
void write_run(const RunFolder& run, std::span<const std::string> parts, const fs::path& out) {
  std::error_code failure;
  fs::create_directories(out, failure);
  std::vector<StoredLines> files;
  for (const std::string& part : parts) files.emplace_back(fs::path(part) / "records.jsonl");
  write_whole(out / "records.jsonl", [&](const TextSink& sink) {
    for (const RecordEntry& record : run.records) sink(files[record.part].at(record.place) + "\n");
  });
  write_whole(out / "manifest.json", json_text(run.manifest, 2) + "\n");
  write_plan(out, run.plan);
}

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out;
};

void merge(const MergeArguments& arguments) {
  const auto& [folders, out] = arguments;
  require_no_run(out);
  std::vector<RunFolder> parts;
  for (const std::string& folder : folders) parts.push_back(read_run(folder));
  RunFolder merged = merge_runs(std::move(parts));
  write_run(merged, folders, out);
  merged.path = out;
  const RunStatus status = status_of(merged);
  write_report(out, evaluation_of_run(out, limits_of_run(out)), {"md", "csv"});
  fmt::print("{} records of {} runs are in {}\n", status.planned - status.pending, folders.size(), out);
  if (status.pending > 0)
    fmt::print(stderr, "{} cases of the plan have no record yet; see `signorini status`\n", status.pending);
}

}  // namespace

void add_merge_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "merge", merge,
      "Joins the records of several runs, such as shards, each case once. Refuses runs of different machines "
      "(processor, number of processors, governor), limits, builds, suites or cases at a time: their times "
      "would not be comparable.");
  command.option("dirs", arguments->folders, "folders of runs", {.required = true});
  command.option("--out", arguments->out, "folder of the whole: new, or an earlier merge",
                 {.required = true});
}

}  // namespace signorini
