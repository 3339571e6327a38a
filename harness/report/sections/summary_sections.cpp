#include "harness/report/sections/summary_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "harness/plan/case_name.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

struct Tally {
  int cases = 0, not_applicable = 0, converged = 0, certified = 0, same = 0, other = 0, inaccurate = 0;
  bool timed = true;
  std::vector<double> times;  // of applicable cases, infinite where they failed
};

void count(const Record& record, Tally& tally) {
  ++tally.cases;
  if (record.status == Status::not_applicable) {
    ++tally.not_applicable;
    return;
  }
  const bool converged = record.status == Status::converged;
  tally.converged += converged ? 1 : 0;
  tally.inaccurate += record.status == Status::inaccurate ? 1 : 0;
  if (converged && !record.seconds) tally.timed = false;
  tally.times.push_back(converged && record.seconds ? record.seconds->median
                                                    : std::numeric_limits<double>::infinity());
  if (!converged || record.certificate.status != CertificateStatus::certified) return;
  ++tally.certified;
  if (record.certificate.same_orbit) ++(*record.certificate.same_orbit ? tally.same : tally.other);
}

double median_of(const Tally& tally) {
  return tally.times.empty() || !tally.timed ? std::numeric_limits<double>::infinity() : median(tally.times);
}

std::string median_text(const Tally& tally) {
  if (tally.times.empty()) return "no applicable case";
  if (tally.converged == 0) return "all failed";
  if (!tally.timed) return "not timed";
  const double middle = median_of(tally);
  return std::isfinite(middle) ? time_text(middle) : "half or more failed";
}

Table summary_table(const std::vector<Record>& records) {
  std::map<std::string, Tally> tallies;
  for (const Record& record : records) count(record, tallies[record.method]);
  Table table{{"method", "cases", "not applicable", "converged", "inaccurate", "failed", "certified",
               "same orbit", "other orbit", "median time, failures infinite"},
              {}};
  for (const auto& [method, tally] : tallies) {
    const int failed = tally.cases - tally.not_applicable - tally.converged - tally.inaccurate;
    const int applicable = tally.cases - tally.not_applicable;
    table.rows.push_back({method, count_cell(tally.cases), count_cell(tally.not_applicable),
                          Cell(fmt::format("{} of {}", tally.converged, applicable), tally.converged),
                          count_cell(tally.inaccurate), count_cell(failed), count_cell(tally.certified),
                          count_cell(tally.same), count_cell(tally.other),
                          Cell(median_text(tally), median_of(tally))});
  }
  return table;
}

/// The figures of one method at one resolution over all scenes to which it applies; infinite where it failed.
struct Speed {
  std::string method;
  std::vector<double> errors, times, ratios;
};

std::vector<Speed> speeds(const std::vector<Record>& records) {
  const auto solved = [](const Record& r) {
    return r.status == Status::converged && r.certificate.status == CertificateStatus::certified && r.seconds;
  };
  std::map<std::string, double> baseline;  // by scene
  for (const Record& r : records) {
    if (resolution_of(r) == kTimeBaseline && solved(r)) baseline[r.scene] = r.seconds->median;
  }
  std::vector<Speed> result;
  std::map<std::string, std::size_t> place;
  constexpr double kFailed = std::numeric_limits<double>::infinity();
  for (const Record& r : records) {
    if (r.status == Status::not_applicable) continue;
    const std::string method = resolution_of(r);
    if (place.try_emplace(method, result.size()).second) result.push_back({method, {}, {}, {}});
    Speed& speed = result[place[method]];
    const bool good = solved(r);
    const Measure error = r.errors.x_l2 ? r.errors.x_l2 : r.errors.u_l2;
    const double floor = measurable_error(r);
    speed.errors.push_back(good && error ? std::max(*error, floor) : kFailed);
    speed.times.push_back(good ? r.seconds->median : kFailed);
    if (const auto found = baseline.find(r.scene); found != baseline.end())
      speed.ratios.push_back(good ? r.seconds->median / found->second : kFailed);
  }
  std::stable_sort(result.begin(), result.end(), [](const Speed& a, const Speed& b) {
    return a.method != b.method && natural_less(a.method, b.method);
  });
  return result;
}

Table speed_table(const std::vector<Record>& records) {
  Table table{{"method", "solved", "error of x, median", "time, median",
               fmt::format("time / {}, median", kTimeBaseline)},
              {}};
  const auto text = [](const std::vector<double>& values, const auto& print) {
    if (values.empty()) return Cell("not measured");
    const double middle = median(values);
    return Cell(std::isfinite(middle) ? print(middle) : std::string("half or more failed"), middle);
  };
  for (const Speed& speed : speeds(records)) {
    const auto solved = std::count_if(speed.times.begin(), speed.times.end(),
                                      [](double time) { return std::isfinite(time); });
    table.rows.push_back(
        {speed.method, Cell(fmt::format("{} of {}", solved, speed.times.size()), static_cast<double>(solved)),
         text(speed.errors, [](double e) { return fmt::format("{:.1e}", e); }),
         text(speed.times, [](double t) { return time_text(t); }),
         text(speed.ratios, [](double r) { return fmt::format("{:.2g}", r); })});
  }
  return table;
}

}  // namespace

std::vector<Section> summary_sections(const Evaluation& evaluation) {
  return {
      {.id = "summary",
       .title = "Summary",
       .text = "What became of every case, and only then a time; failures count as infinite in the median.",
       .table = summary_table(evaluation.records())}};
}

std::vector<Section> speed_sections(const Evaluation& evaluation) {
  return {{.id = "speed",
           .title = "Speed beside error",
           .text =
               "Each resolution over all scenes. Medians take failures as infinite; the errors mix laws and "
               "scenes, and rank nothing.",
           .table = speed_table(evaluation.records())}};
}

}  // namespace signorini
