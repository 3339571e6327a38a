#include "harness/report/evaluation/evaluation.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "harness/isolation/freed_after.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/run_folder/side_by_side.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

bool before(const CaseResult& a, const CaseResult& b) {
  if (a.scene->name != b.scene->name) return natural_less(a.scene->name, b.scene->name);
  if (a.choice->method != b.choice->method) return a.choice->method < b.choice->method;
  return natural_less(a.case_id, b.case_id);
}

bool response_before(const Record& a, const Record& b) {
  if (a.scene != b.scene) return natural_less(a.scene, b.scene);
  const ResponseWay first = a.response->question.way, second = b.response->question.way;
  return first != second ? first < second : natural_less(a.case_id, b.case_id);
}

CaseResults results_of_records(const std::vector<Record>& records) {
  CaseResults results;
  for (const Record& record : records) results.add(record);
  return results;
}

/// Records sorted by their keys, so that records of one name have one order.
std::vector<Record> by_key(std::vector<Record> records) {
  std::ranges::stable_sort(records, {}, &Record::key);
  return records;
}

/// Evaluation::times_remark of the run in a folder.
std::string times_remark_of(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "manifest.json";
  if (!std::filesystem::exists(file)) return {};
  const nlohmann::ordered_json manifest = read_manifest(file);
  const std::string remarks = remarks_on_times(manifest);
  if (!remarks.empty()) return remarks;
  const std::string why = why_not_comparable(manifest);
  return why.empty() ? why : "Times of this run are not comparable: " + why + ".";
}

/// Reads from records that it keeps.
RecordReader reader_of(std::shared_ptr<const std::vector<Record>> records) {
  return [records = std::move(records)](std::size_t source) { return (*records)[source]; };
}

/// The part of a list in the order of its scenes that is of this one.
template <class List, class SceneOf>
auto part_of_scene(const List& list, const std::string& scene, const SceneOf& scene_of) {
  const auto begin = std::ranges::lower_bound(list, scene, natural_less, scene_of);
  const auto end = std::ranges::upper_bound(begin, list.end(), scene, natural_less, scene_of);
  return std::span(std::to_address(begin), static_cast<std::size_t>(end - begin));
}

}  // namespace

Evaluation::Evaluation(std::vector<Record> records, const Limits& limits)
    : Evaluation(std::make_shared<const std::vector<Record>>(by_key(std::move(records))), limits) {}

Evaluation::Evaluation(const std::shared_ptr<const std::vector<Record>>& records, const Limits& limits)
    : Evaluation(results_of_records(*records), reader_of(records), limits) {}

Evaluation::Evaluation(CaseResults results, RecordReader read, const Limits& limits, std::string times_remark)
    : results_(std::move(results)),
      read_(std::move(read)),
      time_limit_(limits.timeout),
      times_remark_(std::move(times_remark)) {
  std::ranges::stable_sort(results_.all, before);
  std::ranges::stable_sort(results_.responses, response_before);
  repeated_ = repeated_problems(results_.all);
  studies_ = resolution_studies(results_.all);
  groups_ = ranking_groups(
      studies_, [this](const std::string& scene) { return is_ranked(scene); },
      [this](const std::string& scene) { return is_contact_free(scene); });
  for (const ResolutionStudy& study : studies_) {
    configurations_.push_back(study.configuration);
    if (scenes_.empty() || scenes_.back() != study.scene) scenes_.push_back(study.scene);
  }
  std::sort(configurations_.begin(), configurations_.end());
  configurations_.erase(std::unique(configurations_.begin(), configurations_.end()), configurations_.end());
}

std::span<const CaseResult> Evaluation::results_of(const std::string& scene) const {
  return part_of_scene(results_.all, scene,
                       [](const CaseResult& result) -> const std::string& { return result.scene->name; });
}

std::span<const ResolutionStudy> Evaluation::studies_of(const std::string& scene) const {
  return part_of_scene(studies_, scene, &ResolutionStudy::scene);
}

bool Evaluation::is_repeated(const ResolutionStudy& study) const {
  return std::ranges::all_of(study.runs, [&](const ScoredRun& run) { return is_repeated(*run.result); });
}

bool Evaluation::is_ranked(const std::string& scene) const {
  const std::span<const CaseResult> results = results_of(scene);
  const std::optional<RepresentedLaw>& law = results.front().scene->law;
  if (law && std::holds_alternative<std::monostate>(*law)) return false;
  const auto counts_elsewhere = [&](const CaseResult& result) { return is_repeated(result); };
  const auto counts_here = [&](const CaseResult& result) {
    return !is_repeated(result) && result.outcome.status != Status::not_applicable;
  };
  return std::ranges::any_of(results, counts_here) || std::ranges::none_of(results, counts_elsewhere);
}

bool Evaluation::is_contact_free(const std::string& scene) const {
  return std::ranges::any_of(results_of(scene), [](const CaseResult& r) { return r.outcome.contact_free; });
}

std::size_t Evaluation::place_of(const CaseResult& result) const {
  return static_cast<std::size_t>(&result - results_.all.data());
}

std::size_t Evaluation::place_of(const std::string& configuration) const {
  return static_cast<std::size_t>(
      std::lower_bound(configurations_.begin(), configurations_.end(), configuration) -
      configurations_.begin());
}

Evaluation evaluation_of_run(const std::filesystem::path& folder, const Limits& limits) {
  const FreedAfter freed(0);
  CaseResults results;
  std::vector<LinePlace> places;
  {
    RunFolder run = read_entries(folder, [&](const Record& record) { results.add(record); });
    run.plan = {};
    std::ranges::stable_sort(run.records, {}, &RecordEntry::key);
    std::vector<std::size_t> sources;
    for (const RecordEntry& entry : run.records) {
      sources.push_back(entry.ordinal);
      places.resize(std::max(places.size(), entry.ordinal + 1));
      places[entry.ordinal] = entry.place;
    }
    results.keep(sources);
  }
  const auto records = std::make_shared<StoredRecords>(folder / "records.jsonl");
  return Evaluation(
      std::move(results),
      [records, places = std::move(places)](std::size_t source) { return records->at(places[source]); },
      limits, times_remark_of(folder));
}

}  // namespace signorini
