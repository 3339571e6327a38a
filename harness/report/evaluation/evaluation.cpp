#include "harness/report/evaluation/evaluation.hpp"

#include <algorithm>

#include "harness/report/evaluation/outcome.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

bool before(const Record& a, const Record& b) {
  if (a.scene != b.scene) return natural_less(a.scene, b.scene);
  if (a.method != b.method) return a.method < b.method;
  if (a.case_id != b.case_id) return natural_less(a.case_id, b.case_id);
  return a.key < b.key;
}

}  // namespace

Evaluation::Evaluation(std::vector<Record> records, const Limits& limits)
    : records_(std::move(records)), time_limit_(limits.timeout) {
  std::ranges::stable_sort(records_, before);
  repeated_ = repeated_problems(records_);
  studies_ = resolution_studies(records_);
  groups_ = ranking_groups(studies_);
  for (const ResolutionStudy& study : studies_) {
    configurations_.push_back(study.configuration);
    if (scenes_.empty() || scenes_.back() != study.scene) scenes_.push_back(study.scene);
  }
  std::sort(configurations_.begin(), configurations_.end());
  configurations_.erase(std::unique(configurations_.begin(), configurations_.end()), configurations_.end());
}

bool Evaluation::is_repeated(const ResolutionStudy& study) const {
  return std::ranges::all_of(study.runs, [&](const ScoredRun& run) { return is_repeated(*run.record); });
}

std::size_t Evaluation::place_of(const Record& record) const {
  return static_cast<std::size_t>(&record - records_.data());
}

std::size_t Evaluation::place_of(const std::string& configuration) const {
  return static_cast<std::size_t>(
      std::lower_bound(configurations_.begin(), configurations_.end(), configuration) -
      configurations_.begin());
}

}  // namespace signorini
