#include "harness/compare/history.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/merge.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// A case with its record in each run; null where that has none.
using CommonCase = std::vector<const Record*>;

bool is_certified(const Record* record) { return claim_of(*record) == Claim::certified; }

/// The cases that count in every run.
std::vector<CommonCase> common_cases(const std::vector<WholeRun>& runs) {
  std::map<std::pair<std::string, std::string>, CommonCase> cases;  // by name and text of the scene
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const Record& record : runs[i].records) {
      if (record.response) continue;
      CommonCase& one = cases[{record.case_id, record.scene_sha256}];
      one.resize(runs.size(), nullptr);
      one[i] = &record;
    }
  }
  std::vector<CommonCase> common;
  for (auto& [name, records] : cases) {
    const auto is_there = [](const Record* record) { return record != nullptr; };
    const auto applies = [](const Record* record) { return record->status != Status::not_applicable; };
    if (std::ranges::all_of(records, is_there) && std::ranges::any_of(records, applies))
      common.push_back(std::move(records));
  }
  return common;
}

std::string text_at(const Json& manifest, const char* place) {
  const Json::json_pointer pointer(place);
  return manifest.contains(pointer) ? manifest.at(pointer).get<std::string>() : std::string();
}

HistoryPoint described(const RunFolder& folder) {
  return {.run = run_name(folder.path),
          .date = text_at(folder.manifest, "/date"),
          .commit = text_at(folder.manifest, "/build/commit").substr(0, 12)};
}

/// What the times of each run are multiplied by; nothing, and why in its point, where they do not count.
std::vector<std::optional<double>> factors_of(const std::vector<WholeRun>& runs,
                                              std::vector<HistoryPoint>& points) {
  std::vector<std::optional<double>> factors(runs.size());
  const RunFolder* first = nullptr;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunFolder& folder = runs[i].folder;
    points[i].hides_time = why_not_comparable(folder.manifest);
    if (!points[i].hides_time.empty()) continue;
    if (first == nullptr) first = &folder;
    factors[i] = machine_difference(*first, folder) ? times_factor(first->manifest, folder.manifest) : 1.0;
    if (!factors[i])
      points[i].hides_time = "its machine is another one, without the time of a calibration solve";
  }
  return factors;
}

/// Median error of a run over cases.
Measure median_error(const std::vector<CommonCase>& cases, std::size_t run) {
  std::vector<double> errors;
  for (const CommonCase& one : cases)
    if (const Measure& error = one[run]->errors.x_l2)
      errors.push_back(std::max(*error, measurable_error(*one[run])));
  return errors.empty() ? std::nullopt : Measure(median(std::move(errors)));
}

/// Geometric mean of the median times of a run over cases [s].
Measure mean_time(const std::vector<CommonCase>& cases, std::size_t run) {
  double sum = 0.0;
  for (const CommonCase& one : cases) sum += std::log(one[run]->seconds->median);
  return cases.empty() ? std::nullopt : Measure(std::exp(sum / static_cast<double>(cases.size())));
}

}  // namespace

History history_of(std::vector<WholeRun> runs) {
  std::ranges::stable_sort(runs, {},
                           [](const WholeRun& run) { return text_at(run.folder.manifest, "/date"); });
  History history;
  for (const WholeRun& run : runs) history.points.push_back(described(run.folder));
  const std::vector<std::optional<double>> factors = factors_of(runs, history.points);
  std::vector<CommonCase> cases = common_cases(runs);
  history.cases = cases.size();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto certified = [&](const CommonCase& one) { return is_certified(one[i]); };
    history.points[i].certified = static_cast<std::size_t>(std::ranges::count_if(cases, certified));
  }
  std::erase_if(cases, [](const CommonCase& one) { return !std::ranges::all_of(one, is_certified); });
  history.certified = cases.size();
  for (std::size_t i = 0; i < runs.size(); ++i) history.points[i].error = median_error(cases, i);
  std::erase_if(cases, [&](const CommonCase& one) {
    for (std::size_t i = 0; i < one.size(); ++i)
      if (factors[i] && !(one[i]->seconds && one[i]->seconds->median > 0.0)) return true;
    return false;
  });
  history.timed = cases.size();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!factors[i]) continue;
    if (const Measure mean = mean_time(cases, i)) history.points[i].seconds = *factors[i] * *mean;
  }
  return history;
}

}  // namespace signorini
