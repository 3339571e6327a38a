#include "harness/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "harness/report/document/cells.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/merge.hpp"

namespace signorini {

namespace {

std::optional<CaseChange> change(const Record& record, ChangeKind kind, std::string detail) {
  return CaseChange{.case_id = record.case_id, .kind = kind, .detail = std::move(detail)};
}

std::string said(const Record& record) {
  return record.message.empty() ? std::string(status_name(record.status))
                                : fmt::format("{}: {}", status_name(record.status), record.message);
}

/// 2: converged; 1: answered, but the harness disagrees; 0: no answer.
int standing(const Record& record) {
  if (record.status == Status::converged) return 2;
  return record.status == Status::inaccurate ? 1 : 0;
}

std::optional<CaseChange> status_change(const Record& before, const Record& after) {
  const int was = standing(before), is = standing(after);
  if (was == is) return std::nullopt;
  const std::string detail = fmt::format("{} became {}", status_name(before.status), said(after));
  if (is < was) return change(before, is == 0 ? ChangeKind::broken : ChangeKind::less_accurate, detail);
  return change(before, was == 0 ? ChangeKind::repaired : ChangeKind::more_accurate, detail);
}

std::optional<CaseChange> accuracy_change(const Record& before, const Record& after) {
  if (before.response && after.response) {
    const std::optional<ResponseChange> found = response_change(*before.response, *after.response);
    if (!found) return std::nullopt;
    return change(before, found->worse ? ChangeKind::less_accurate : ChangeKind::more_accurate,
                  found->detail);
  }
  const bool was = before.certificate.status == CertificateStatus::certified;
  const bool is = after.certificate.status == CertificateStatus::certified;
  if (was != is) {
    const std::string detail =
        is ? "its orbit is certified now" : "no certificate: " + after.certificate.reason;
    return change(before, is ? ChangeKind::more_accurate : ChangeKind::less_accurate, detail);
  }
  if (!before.errors.x_l2 || !after.errors.x_l2) return std::nullopt;
  // Records of earlier versions have no error of the force: of x alone then.
  const bool levels = before.errors.x_worst && after.errors.x_worst;
  const auto bounded = [levels](const Record& record) {
    // An error below ten error bars is known to be no larger than they are.
    return std::max(*(levels ? level_error(record) : record.errors.x_l2), measurable_error(record));
  };
  const double old_error = bounded(before), new_error = bounded(after);
  const std::string detail =
      levels ? fmt::format("error of x and force {:.1e} became {:.1e}", old_error, new_error)
             : fmt::format("error of x {} became {}", error_text(before), error_text(after));
  if (new_error > kErrorFactor * old_error) return change(before, ChangeKind::less_accurate, detail);
  if (old_error > kErrorFactor * new_error) return change(before, ChangeKind::more_accurate, detail);
  return std::nullopt;
}

/// Changes of the counts of work, which are free of noise and explain a change of time.
std::string work_remark(const Record& before, const Record& after) {
  constexpr std::array kCounts{std::pair{"iterations", &Work::iterations}, std::pair{"pivots", &Work::pivots},
                               std::pair{"right-hand sides", &Work::rhs_evaluations},
                               std::pair{"factorisations", &Work::factorisations}};
  std::string text;
  for (const auto& [name, count] : kCounts) {
    const auto &was = before.work.counts.*count, &is = after.work.counts.*count;
    if (!was || !is || *was == *is) continue;
    text += fmt::format("{}{} {} became {}", text.empty() ? "" : ", ", name, *was, *is);
  }
  return text;
}

std::string why_no_times(const RunFolder& before, const RunFolder& after) {
  for (const RunFolder* run : {&before, &after}) {
    if (const std::string why = why_not_comparable(run->manifest); !why.empty())
      return fmt::format("times are not compared: those of {} are not comparable: {}", run->path.string(),
                         why);
  }
  return machine_difference(before, after) ? "times are not compared: the runs are of different machines"
                                           : "";
}

void compare_case(const Record& before, const Record& after, Comparison& result) {
  ++result.cases;
  if (before.status == Status::not_applicable && after.status == Status::not_applicable) return;
  auto found = status_change(before, after);
  if (!found && standing(before) > 0) found = accuracy_change(before, after);
  if (found) result.changes.push_back(*found);
  if (const std::string work = work_remark(before, after); !work.empty())
    result.remarks.push_back(fmt::format("{}: {}", before.case_id, work));
}

bool comparable_times(const Record& before, const Record& after) {
  return standing(before) == 2 && standing(after) == 2 && before.seconds && after.seconds &&
         !before.seconds->jobs && !after.seconds->jobs;
}

void compare_times(const std::vector<TimePair>& pairs, Comparison& result) {
  result.timed = pairs.size();
  const std::vector<TimeChange> verdicts = judge_cases(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (verdicts[i] == TimeChange::none) continue;
    const TimePair& pair = pairs[i];
    result.changes.push_back(
        {pair.case_id, verdicts[i] == TimeChange::slower ? ChangeKind::slower : ChangeKind::faster,
         fmt::format("{} became {}, {:.2f} times", time_text(pair.before.median),
                     time_text(pair.after.median), pair.after.median / pair.before.median)});
  }
  result.methods = judge_methods(pairs);
}

std::optional<ResponseChange> share_change(const char* name, double before, double after, double sign) {
  if (std::abs(after - before) <= kShareTolerance) return std::nullopt;
  return ResponseChange{
      .worse = sign * (after - before) < 0.0,
      .detail = fmt::format("{} {:.1f} % became {:.1f} %", name, 100.0 * before, 100.0 * after)};
}

/// Points of the exact response that were located; of that itself, which is compared with none, all.
std::ptrdiff_t located(const RecordedResponse& response) {
  if (!response.comparison) return std::ssize(response.located);
  return std::ranges::count_if(response.comparison->points,
                               [](const PointMatch& match) { return match.frequency.has_value(); });
}

}  // namespace

std::string_view change_name(ChangeKind kind) {
  constexpr std::array<std::string_view, 6> kNames{"broken",   "less accurate", "slower",
                                                   "repaired", "more accurate", "faster"};
  return kNames[static_cast<std::size_t>(kind)];
}

WholeRun read_whole_run(const std::filesystem::path& folder) {
  return {.folder = read_description(folder), .records = read_current_records(folder)};
}

Comparison compare_runs(const WholeRun& before, const WholeRun& after) {
  Comparison result;
  const std::string no_times = why_no_times(before.folder, after.folder);
  if (!no_times.empty()) result.remarks.push_back(no_times);
  std::map<std::string, const Record*> present;
  for (const Record& record : after.records) present[record.case_id] = &record;
  std::set<std::string> met;
  std::vector<TimePair> pairs;
  for (const Record& record : before.records) {
    met.insert(record.case_id);
    const auto found = present.find(record.case_id);
    if (found == present.end()) {
      if (standing(record) == 2)
        result.changes.push_back({record.case_id, ChangeKind::broken, "has no record any more"});
      continue;
    }
    const Record& now = *found->second;
    compare_case(record, now, result);
    if (no_times.empty() && comparable_times(record, now))
      pairs.push_back({record.case_id, record.method, *record.seconds, *now.seconds});
  }
  for (const Record& record : after.records) {
    if (!met.contains(record.case_id))
      result.remarks.push_back(fmt::format("{}: only in the second run", record.case_id));
  }
  compare_times(pairs, result);
  std::ranges::stable_sort(result.changes, {}, &CaseChange::kind);
  return result;
}

bool has_regression(const Comparison& comparison) {
  const auto bad = [](const CaseChange& change) { return change.kind <= ChangeKind::slower; };
  const auto slow = [](const MethodTimes& method) { return method.verdict == TimeChange::slower; };
  return std::ranges::any_of(comparison.changes, bad) || std::ranges::any_of(comparison.methods, slow);
}

std::optional<ResponseChange> response_change(const RecordedResponse& before, const RecordedResponse& after) {
  if (before.comparison.has_value() != after.comparison.has_value())
    return ResponseChange{.worse = before.comparison.has_value(),
                          .detail = "it is compared with an exact response in one of the two only"};
  if (before.comparison) {
    const CurveComparison &was = *before.comparison, &is = *after.comparison;
    if (auto found = share_change("found", was.close.covered, is.close.covered, 1.0)) return found;
    if (auto found = share_change("false", was.wide.false_share, is.wide.false_share, -1.0)) return found;
  }
  const std::ptrdiff_t was = located(before), is = located(after);
  if (was == is) return std::nullopt;
  return ResponseChange{.worse = is < was,
                        .detail = fmt::format("special points located {} became {}", was, is)};
}

}  // namespace signorini
