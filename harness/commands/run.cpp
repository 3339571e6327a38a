#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/build_info.hpp"
#include "harness/commands/command_line.hpp"
#include "harness/doctor/calibration.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/scene_choice.hpp"
#include "harness/plan/suite.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/report.hpp"
#include "harness/responses/response_plan.hpp"
#include "harness/run/suite_run.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/merge.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/run_folder/shards.hpp"
#include "harness/terminal/run_output.hpp"
#include "harness/terminal/terminal.hpp"
#include "harness/text/json.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

struct RunArguments {
  std::string suite = "quick";
  Narrowing narrowing;
  std::optional<std::string> out;
  bool resume = false;
  bool dry_run = false;
  bool waveforms = false;
  bool verbose = false;
  std::optional<double> timeout;
  std::optional<int> memory_mb;
  std::optional<int> repetitions;
  Schedule schedule;
  std::optional<std::string> shard;
  std::string durations;
  std::vector<std::string> words;  // the command line
};

/// CLI11 would wrap a negative number around.
std::string not_negative(const std::string& text) {
  return text.starts_with('-') ? fmt::format("seed = {} (must be 0 or more)", text) : std::string();
}

/// CLI11 would take an empty word for an option left out.
std::string not_empty(const std::string& text) {
  return text.empty() ? "shard = '' (must be I/N with 1 <= I <= N)" : std::string();
}

Limits limits_of(const RunArguments& arguments, const Suite& suite) {
  Limits limits = suite.limits;
  limits.timeout = arguments.timeout.value_or(limits.timeout);
  limits.memory_mb = arguments.memory_mb.value_or(limits.memory_mb);
  limits.repetitions = arguments.repetitions.value_or(limits.repetitions);
  return limits;
}

void print_plan(const Plan& plan) {
  for (const Case& planned_case : plan.cases) fmt::print("{}\n", planned_case.id);
  fmt::print(stderr, "{} on {}\n", plural(std::ssize(plan.cases), "case"),
             plural(std::ssize(plan.scenes), "scene"));
}

Plan plan_of(const RunArguments& arguments, const Suite& suite) {
  Narrowing narrowing = arguments.narrowing;
  narrowing.seed = arguments.schedule.seed;
  Plan plan = plan_of_suite(suite, narrowing, method_catalogue(), shipped_scenes());
  if (!arguments.shard) return plan;
  Durations durations;
  if (!arguments.durations.empty()) durations = Durations(read_run(arguments.durations).records);
  return take_shard(plan, parse_shard(*arguments.shard), durations);
}

nlohmann::ordered_json manifest_of(const RunArguments& arguments, const Suite& suite, const Limits& limits,
                                   const Plan& plan) {
  nlohmann::ordered_json manifest = make_manifest(suite, limits, arguments.schedule, arguments.words);
  for (const Case& planned_case : plan.cases) {
    const MethodEntry& entry = *planned_case.choice.entry;
    if (!entry.plugin.empty()) manifest["plugins"][entry.name] = entry.plugin;
  }
  if (arguments.shard) manifest["shard"] = *arguments.shard;
  if (build_may_be_timed())
    manifest["calibration"] = {
        {"version", kCalibrationVersion}, {"seconds", calibration_seconds()}, {"solves", kCalibrationSolves}};
  return manifest;
}

/// Manifest and plan, joined to those of a run that this one resumes. \throws UsageError if it cannot be
/// resumed
void describe_run(RunFolder run, bool resume) {
  if (resume && std::filesystem::exists(run.path / "manifest.json")) {
    const RunFolder before = read_description(run.path);
    require_same_machine(before, run);
    run.plan = joined_plan(before, run);
    join_plugins(run.manifest, before.manifest);
    // Nothing has been timed yet under the present load.
    for (const char* key : {"load", "running", "load_end"}) {
      run.manifest["machine"].erase(key);
      if (before.manifest.contains("machine") && before.manifest["machine"].contains(key))
        run.manifest["machine"][key] = before.manifest["machine"][key];
    }
    note_times(run.manifest, why_not_comparable(before.manifest));
  }
  write_whole(run.path / "manifest.json", json_text(run.manifest, 2) + "\n");
  write_plan(run.path, run.plan);
}

/// Runs what is missing; prints scene by scene what became of it. \throws UsageError that says how the rest
/// is run, where the machine is short of something
SuiteRunResult run_missing(const RunArguments& arguments, const Plan& plan, Runner& runner,
                           RecordStore& store) {
  try {
    if (arguments.verbose) return run_plan(plan, runner, store, arguments.schedule, print_scene);
    SceneLines lines(plan.scenes.size());
    return run_plan(plan, runner, store, arguments.schedule,
                    [&](const std::vector<Record>& records) { lines.add(records); });
  } catch (const MachineFull& error) {
    throw UsageError(fmt::format("{}; the same command with --resume --out {} does the rest", error.what(),
                                 store.file().parent_path().string()));
  }
}

/// Where the results go: of a single scene of one's own into a folder of its name.
std::filesystem::path folder_of(const RunArguments& arguments, const Suite& suite, const Plan& plan) {
  const bool own = plan.scenes.size() == 1 && std::ranges::any_of(arguments.narrowing.scenes, names_path);
  return arguments.out.value_or("results/local-" + (own ? plan.scenes.front().problem.name : suite.name));
}

/// What is about to happen, and what became of an earlier run there.
void announce(const Plan& plan, const Limits& limits, const std::filesystem::path& folder, bool earlier) {
  fmt::print(stderr, "{} on {}, of at most {:g} s each; results go to {}\n",
             plural(std::ssize(plan.cases), "case"), plural(std::ssize(plan.scenes), "scene"), limits.timeout,
             folder.string());
  if (earlier) fmt::print(stderr, "the records of an earlier run there are kept as records.previous.jsonl\n");
}

int run_suite(const RunArguments& arguments) {
  const Suite suite = load_suite(arguments.suite);
  const Plan plan = plan_of(arguments, suite);
  if (arguments.dry_run) {
    print_plan(plan);
    return kDone;
  }
  const std::filesystem::path folder = folder_of(arguments, suite, plan);
  Runner runner(limits_of(arguments, suite));
  if (arguments.waveforms) runner.keep_waveforms();
  const bool earlier = !arguments.resume && std::filesystem::exists(folder / "records.jsonl");
  RecordStore store(folder, arguments.resume);
  const nlohmann::ordered_json manifest = manifest_of(arguments, suite, runner.limits(), plan);
  describe_run({.path = folder, .manifest = manifest, .plan = planned_cases(plan, runner)}, arguments.resume);
  announce(plan, runner.limits(), folder, earlier);
  if (!build_may_be_timed()) fmt::print(stderr, "this is not a Release build: no times are recorded\n");
  watch_interrupts();
  const SuiteRunResult result = run_missing(arguments, plan, runner, store);
  if (result.ran > 0) close_manifest(folder, why_not_comparable(manifest));
  if (result.interrupted) {
    fmt::print(stderr,
               "interrupted after {} of {} cases; the same command with --resume --out {} does the rest\n",
               result.ran + result.present, plan.cases.size(), folder.string());
    return kInterrupted;
  }
  // Read as `report` reads them: a run that resumes another reports the records of both.
  const Evaluation evaluation = evaluation_of_run(folder, runner.limits());
  write_report(folder, evaluation, {"md", "csv"});
  if (arguments.verbose)
    fmt::print("{}\n", markdown_report(closing_sections(evaluation, result.present == 0)));
  std::vector<std::string> failures;
  for (const CaseResult& result : evaluation.results()) {
    if (is_unexpected(result.case_id, result.outcome.status, suite)) failures.push_back(result.case_id);
  }
  for (const Record& record : evaluation.responses()) {
    if (is_unexpected(record.case_id, record.status, suite)) failures.push_back(record.case_id);
  }
  fmt::print("{}",
             screen_report(evaluation, {.heading = fmt::format("{} cases run, {} already there; records and "
                                                               "manifest are in {}",
                                                               result.ran, result.present, folder.string()),
                                        .folder = folder.string(),
                                        .program = typed_program(),
                                        .unexpected = failures,
                                        .colour = takes_colour(STDOUT_FILENO)}));
  return failures.empty() ? kDone : kUnexpectedFailure;
}

}  // namespace

void add_run_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "run", run_suite, "The benchmark: every method of a suite on every scene, at several resolutions.");
  arguments->words = command.words();
  command.option("suite", arguments->suite, "suite name or file");
  command.option("--methods", arguments->narrowing.methods,
                 "methods by glob, A*:B*-C*, options in brackets: name[key=v1|v2,key=v]");
  command.option(
      "--scenes", arguments->narrowing.scenes,
      "scenes of the suite by glob, A*:B*-C*, others that ship by name, and files, folders or globs of "
      "files of one's own, own.toml:folder:'more/*.toml'; may be repeated",
      {.one_word = true});
  command.option(
      "--out", arguments->out,
      "folder of the results; results/local-SUITE if absent, of one scene of one's own local-SCENE");
  command.flag("--resume", arguments->resume,
               "keep the records that are there, run what is missing or stale");
  command.option("--timeout", arguments->timeout, "processor time of one run [s]",
                 {.complaint = positive_seconds});
  command.option("--memory", arguments->memory_mb, "address space that one run may take [MiB]",
                 {.range = {64, 1 << 24}});
  command.option("--repetitions", arguments->repetitions, "rounds of timing", {.range = {1, 1000}});
  command.flag(
      "--verbose", arguments->verbose,
      "print every table of table.md, each scene's as soon as it is done, before the closing screen");
  command.flag("--waveforms", arguments->waveforms,
               "keep the motions in the records, for the figures of report; doubles their size");
  command.option("--instances", arguments->narrowing.instances,
                 "scenes drawn from each file with ranges (0: as written); if absent as the suite says",
                 {.range = {0, kMostInstances}});
  command.option("--seed", arguments->schedule.seed,
                 "of the scenes that are drawn (--instances), and of the random order of a scene's cases in "
                 "each round",
                 {.complaint = not_negative});
  command.option("--jobs", arguments->schedule.parallel,
                 "cases run at the same time; with more than one, times are not comparable, and say so",
                 {.range = {1, 1024}});
  command.option("--beside", arguments->schedule.beside,
                 "runs that share this machine, this one included; their times are marked as not comparable",
                 {.range = {1, 1024}});
  const Argument shard =
      command.option("--shard", arguments->shard,
                     "I/N: only part I of N, all methods of a scene in one part; merge joins them",
                     {.type_name = "I/N", .complaint = not_empty});
  command.option("--durations", arguments->durations,
                 "folder of an earlier run whose times balance the shards; the same for all of them",
                 {.needs = shard});
  command.flag("--dry-run", arguments->dry_run, "print the plan, one case per line, and run nothing");
}

}  // namespace signorini
