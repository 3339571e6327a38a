// `signorini verify` of the folder of a run.

#include <fmt/format.h>

#include <map>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/commands/verify.hpp"
#include "harness/compare/rerun.hpp"
#include "harness/failure.hpp"
#include "harness/glob.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/progress.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/statistics.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

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
  fmt::print("\n{}\nTimes are medians over the scenes, reported and not judged.\n", to_markdown(table));
}

}  // namespace

int verify_records(const VerifyArguments& arguments, const std::filesystem::path& folder) {
  if (arguments.update)
    throw UsageError(fmt::format(
        "dir = {} (must be a folder of references to be updated; `signorini run` makes records anew)",
        folder.string()));
  std::vector<Record> kept = read_current_records(folder);
  const std::string filter = arguments.scenes.value_or("*");
  std::erase_if(kept, [&](const Record& record) { return !scene_filter_matches(filter, record.scene); });
  Progress progress(kept.size());
  const Rerun result = rerun_records(kept, limits_of_run(folder), arguments.cases, method_catalogue(),
                                     [&](const std::string& what) { progress.begin(what); });
  print_lines(result.differences);
  for (const std::string& remark : result.remarks)
    fmt::print("{}: a time limit decided, no difference\n", remark);
  fmt::print("{} cases, {} differences\n", result.cases, result.differences.size());
  if (!result.time_ratios.empty()) {
    fmt::print("time, new over kept: {:.3g} in the median of {} cases\n", median(result.time_ratios),
               result.time_ratios.size());
    print_relative_times(result.relative_times);
  }
  if (result.interrupted) return kInterrupted;
  return result.differences.empty() ? kDone : kUnexpectedFailure;
}

}  // namespace signorini
