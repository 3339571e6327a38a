#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/plan/case_name.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/evaluation/ranking.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

/// What became of a method's cases.
struct Tally {
  OutcomeCounts counts = {};
  bool timed = true;
  std::vector<double> times = {};  ///< of applicable cases, infinite where they failed
};

void count(const Record& record, Tally& tally) {
  tally.counts.add(record);
  if (record.status == Status::not_applicable) return;
  const bool converged = record.status == Status::converged;
  if (converged && !record.seconds) tally.timed = false;
  tally.times.push_back(converged && record.seconds ? record.seconds->median : kNeverReached);
}

/// The median and how `print` puts it; a reason instead where failures are half or more.
template <class Print>
Cell median_cell(const std::vector<double>& values, const Print& print) {
  const double middle = median(values);
  return {std::isfinite(middle) ? print(middle) : "half or more failed", middle};
}

Cell time_cell(const Tally& tally) {
  if (tally.times.empty()) return {"no applicable case", kNeverReached};
  if (tally.counts.converged() == 0) return {"all failed", kNeverReached};
  if (!tally.timed) return {"not timed", kNeverReached};
  return median_cell(tally.times, time_text);
}

Table summary_table(const std::vector<Record>& records) {
  std::map<std::string, Tally> tallies;
  for (const Record& record : records) count(record, tallies[record.method]);
  Table table{{"method", "cases", "not applicable", "converged", "inaccurate", "failed", "certified",
               "same orbit", "other orbit", "median time, failures infinite"},
              {}};
  for (const auto& [method, tally] : tallies) {
    const OutcomeCounts& n = tally.counts;
    table.rows.push_back({method, count_cell(n.cases), count_cell(n.not_applicable),
                          count_cell(n.converged(), n.applicable()), count_cell(n.refuted),
                          count_cell(n.failed), count_cell(n.certified), count_cell(n.same_orbit),
                          count_cell(n.other_orbit), time_cell(tally)});
  }
  return table;
}

/// The figures of one method at one resolution over all scenes to which it applies; infinite where it failed.
struct Speed {
  std::vector<double> errors, times, ratios;
};

/// Time of a certified answer; infinite for any other.
double solved_time(const Record& record) {
  return claim_of(record) == Claim::certified && record.seconds ? record.seconds->median : kNeverReached;
}

/// In natural order of the names of the resolutions.
std::vector<std::pair<std::string, Speed>> speeds(const std::vector<Record>& records) {
  std::map<std::string, double> baseline;  // by scene
  for (const Record& r : records) {
    if (resolution_of(r) == kTimeBaseline && std::isfinite(solved_time(r)))
      baseline[r.scene] = solved_time(r);
  }
  std::vector<std::pair<std::string, Speed>> result;
  std::map<std::string, std::size_t> places;
  for (const Record& r : records) {
    if (r.status == Status::not_applicable) continue;
    const auto [place, fresh] = places.try_emplace(resolution_of(r), result.size());
    if (fresh) result.push_back({place->first, {}});
    Speed& speed = result[place->second].second;
    speed.errors.push_back(certified_error(r).value_or(kNeverReached));
    speed.times.push_back(solved_time(r));
    if (const auto found = baseline.find(r.scene); found != baseline.end())
      speed.ratios.push_back(solved_time(r) / found->second);
  }
  std::ranges::stable_sort(result, natural_less, &std::pair<std::string, Speed>::first);
  return result;
}

Table speed_table(const std::vector<Record>& records) {
  Table table{{"method", "solved", "error of x, median", "time, median",
               fmt::format("time / {}, median", kTimeBaseline)},
              {}};
  const auto printer = [](const char* format) {
    return [=](double value) { return fmt::format(fmt::runtime(format), value); };
  };
  for (const auto& [method, speed] : speeds(records)) {
    table.rows.push_back(
        {method, count_cell(solved_count(speed.times), std::ssize(speed.times)),
         median_cell(speed.errors, printer("{:.1e}")), median_cell(speed.times, time_text),
         speed.ratios.empty() ? "not measured" : median_cell(speed.ratios, printer("{:.2g}"))});
  }
  return table;
}

}  // namespace

Sections summary_sections(const Evaluation& evaluation) {
  return {
      {.id = "summary",
       .title = "Summary",
       .text = "What became of every case, and only then a time; failures count as infinite in the median.",
       .table = summary_table(evaluation.records())}};
}

Sections speed_sections(const Evaluation& evaluation) {
  return {{.id = "speed",
           .title = "Speed beside error",
           .text =
               "Each resolution over all scenes. Medians take failures as infinite; the errors mix laws and "
               "scenes, and rank nothing.",
           .table = speed_table(evaluation.records())}};
}

}  // namespace signorini
