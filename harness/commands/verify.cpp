#include "harness/commands/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/compare/rerun.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/judge/measures/waveform.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/progress.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/statistics.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Prints times as ratios to the baseline, which mean something on another machine too.
void print_relative_times(const std::vector<RelativeTime>& times) {
  if (times.empty()) {
    fmt::print("times relative to {}: none, it was not timed in both runs\n", kTimeBaseline);
    return;
  }
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> methods;
  for (const RelativeTime& time : times) {
    methods[time.method].first.push_back(time.kept);
    methods[time.method].second.push_back(time.now);
  }
  Table table{{"method", "scenes", fmt::format("time / {}, kept", kTimeBaseline), "now", "now / kept"}, {}};
  for (const auto& [method, ratios] : methods) {
    const double kept = median(ratios.first), now = median(ratios.second);
    table.rows.push_back({method, std::to_string(ratios.first.size()), fmt::format("{:.3g}", kept),
                          fmt::format("{:.3g}", now), fmt::format("{:.2f}", now / kept)});
  }
  fmt::print("\n{}\nTimes are medians over the scenes, reported and not judged.\n",
             to_columns(table, kTerminalWidth));
}

/// Prints what of the records cannot be judged, and what was judged by another plugin.
void print_unjudged(const std::vector<Record>& kept, const Rerun& result) {
  for (const auto& [reason, cases] : result.left_out)
    fmt::print("left out: {}: {}\n", plural(static_cast<std::ptrdiff_t>(cases), "case"), reason);
  for (const std::string& method : result.other_plugins)
    fmt::print("note: the plugin of {} is not the one of the run\n", method);
  const auto drawn = std::ranges::count_if(kept, [](const Record& r) { return r.waveforms.has_value(); });
  if (drawn > 0)
    fmt::print(
        "note: the motions that {} keep{} are not judged: they are drawings, to {:g} % of their range\n",
        plural(drawn, "record"), drawn == 1 ? "s" : "", 100.0 * kKeptTolerance);
}

/// Runs the cases of a run again and prints what differs from its records. \param name  of the run, for
/// messages \return the exit code
int verify_records(const VerifyArguments& arguments, const fs::path& folder, const std::string& name) {
  if (arguments.update)
    throw UsageError(fmt::format(
        "dir = {} (must be a folder of references to be updated; `signorini run` makes records anew)", name));
  std::vector<Record> kept = read_current_records(folder);
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(kept, [&](const Record& record) { return !scene_filter_matches(filter, record.scene); });
  // Times are reported only, and a pack may ask for any number of rounds.
  constexpr int kMostRounds = 9;
  Limits limits = limits_of_run(folder);
  limits.repetitions = std::min(limits.repetitions, kMostRounds);
  Progress progress(kept.size());
  const Rerun result = rerun_records(kept, limits, arguments.cases, method_catalogue(),
                                     [&](const std::string& what) { progress.begin(what); });
  for (const std::string& difference : result.differences) fmt::print("{}\n", difference);
  for (const std::string& remark : result.remarks)
    fmt::print("{}: a time limit decided, no difference\n", remark);
  print_unjudged(kept, result);
  if (result.cases == result.remarks.size() && result.differences.empty() && !result.interrupted)
    throw NothingMatched(fmt::format("dir = {} (holds no case that can be judged here)", name));
  fmt::print(
      "{} cases, {} differences{}\n", result.cases, result.differences.size(),
      result.remarks.empty() ? "" : fmt::format(", {} not told for want of time", result.remarks.size()));
  if (!result.time_ratios.empty()) {
    fmt::print("time, new over kept: {:.3g} in the median of {} cases\n", median(result.time_ratios),
               result.time_ratios.size());
    print_relative_times(result.relative_times);
  }
  if (result.interrupted) return kInterrupted;
  return result.differences.empty() ? kDone : kUnexpectedFailure;
}

int verify(const VerifyArguments& arguments) {
  const fs::path place = arguments.folder ? fs::path(*arguments.folder) : references_folder();
  const auto run = arguments.update ? std::nullopt : std::make_optional<OpenedRun>(place);
  const fs::path folder = run ? run->folder() : place;
  if (run && run->was_packed()) fmt::print("{}: SHA-256 {}\n", place.string(), sha256_of_file(place));
  if (!arguments.update && !fs::is_directory(folder)) refuse_folder(folder);
  refuse_old_responses(folder);
  watch_interrupts();
  return fs::exists(folder / "records.jsonl") ? verify_records(arguments, folder, place.string())
                                              : verify_references(arguments, folder);
}

}  // namespace

void refuse_folder(const std::filesystem::path& folder) {
  throw UsageError(
      fmt::format("dir = {} (must be a folder of references, as verify --update makes it, or of records, as "
                  "run makes it)",
                  folder.string()));
}

void add_verify_command(const Command& program, int& exit_code) {
  const Command command = program.command(
      "verify",
      fmt::format(
          "Repeats stored computations and reports what differs. Of a folder of references: searches every "
          "scene's "
          "orbits again; each kept orbit must be found, or certified "
          "again from its impacts, its events within {:g} times the sum of both "
          "error bars plus {:g} of a period, with the same multipliers and stability. Of a folder with "
          "records.jsonl: runs the cases again; each must end with the same status and an error of x "
          "within a factor of {:g} or below ten error bars, while times are only reported. Of a file that "
          "`pack` made: the same, once its hashes are found right; nothing in it is run. Cases of methods "
          "and scenes that are not here are left out and counted. Exit code 0 "
          "if all is the same, 1 if not, 3 if no case can be judged.",
          kErrorBars, kInstantFloor, kErrorFactor));
  const auto arguments = std::make_shared<VerifyArguments>();
  command.option("dir", arguments->folder,
                 "folder of references or of a run, or a pack; results/references here or above if absent");
  command.option("--scenes", arguments->scenes,
                 "scenes by glob, A*:B*-C*; members of a family only if the glob names them, as "
                 "grazing@*; if absent the "
                 "catalogue but for the scenes tagged large or long-search");
  command.option("--cases", arguments->cases, "cases of a run by glob on SCENE/METHOD[OPTIONS]")
      .shows_default();
  command.flag(
      "--update", arguments->update,
      "search, and keep what is found and what is still certified, instead of comparing; --starts, "
      "--subharmonics (if absent as far as before) and --seed are for this, a comparison searches as the "
      "files say");
  add_search_options(command, arguments->options, arguments->subharmonics);
  command.on_run([arguments, &exit_code] { exit_code = verify(*arguments); });
}

}  // namespace signorini
