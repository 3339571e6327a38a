#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/compare/comparison.hpp"
#include "harness/failure.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"

namespace signorini {

namespace {

void print_methods(const std::vector<MethodTimes>& methods) {
  if (methods.empty()) return;
  constexpr std::array kVerdicts{"faster", "no difference", "slower"};  // in the order of TimeChange
  Table table{{"method", "cases timed", "new / old, median", "probability of chance", "verdict"}, {}};
  for (const MethodTimes& one : methods) {
    table.rows.push_back({one.method, std::to_string(one.cases), fmt::format("{:.3f}", one.ratio),
                          fmt::format("{:.2g}", one.probability),
                          kVerdicts.at(static_cast<std::size_t>(one.verdict))});
  }
  fmt::print("{}\n", to_columns(table, kTerminalWidth));
}

void print_changes(const Comparison& comparison) {
  constexpr int kMostAlike = 10;  // lines of one kind and detail: cases that one run lacks are many
  std::map<std::pair<std::string_view, std::string>, int> counts;
  for (const CaseChange& change : comparison.changes) {
    const std::string_view kind = change_name(change.kind);
    if (++counts[{kind, change.detail}] <= kMostAlike)
      fmt::print("{}: {}: {}\n", kind, change.case_id, change.detail);
  }
  for (const auto& [alike, count] : counts)
    if (count > kMostAlike)
      fmt::print("{}: {} cases more: {}\n", alike.first, count - kMostAlike, alike.second);
  for (const std::string& remark : comparison.remarks) fmt::print("note: {}\n", remark);
  fmt::print("{} cases compared, {} of them timed, {} differences\n", comparison.cases, comparison.timed,
             comparison.changes.size());
}

/// A run from a folder or a pack, which messages name as it was named here.
WholeRun read_named_run(const std::string& place) {
  WholeRun run = read_whole_run(OpenedRun(place).folder());
  run.folder.path = place;
  return run;
}

struct CompareArguments {
  std::string before;
  std::vector<std::string> after;
};

/// Compares each of the later runs with the first.
int compare(const CompareArguments& arguments) {
  const auto& [before, after] = arguments;
  const WholeRun first = read_named_run(before);
  int code = kDone;
  for (const std::string& later : after) {
    const Comparison comparison = compare_runs(first, read_named_run(later));
    if (comparison.cases == 0)
      throw NothingMatched(fmt::format("dirs = {} {} (have no case in common)", before, later));
    if (after.size() > 1)
      fmt::print("{}{} beside {}:\n\n", later == after.front() ? "" : "\n", later, before);
    print_methods(comparison.methods);
    print_changes(comparison);
    if (has_regression(comparison)) code = kRegression;
  }
  return code;
}

}  // namespace

void add_compare_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "compare", compare,
      fmt::format("What got slower, less accurate or broken from one run to another, beyond the "
                  "noise of both. A case is slower if minimum and median of its time grew by {:.0f} % "
                  "({:.0f} % with fewer than {} rounds) and by more than the error bars of both runs "
                  "explain; a method if its cases as a whole did, by {:.0f} %. Of several new runs each is "
                  "compared with the first. Exit code 4 for a regression of any.",
                  100.0 * (kCaseFactor - 1.0), 100.0 * (kCaseFactorFewRounds - 1.0), kManyRounds,
                  100.0 * (kMethodFactor - 1.0)));
  command.option("before", arguments->before, "folder of the run of before, or a pack", {.required = true});
  command.option("after", arguments->after, "folders of the new runs, or packs", {.required = true});
}

}  // namespace signorini
