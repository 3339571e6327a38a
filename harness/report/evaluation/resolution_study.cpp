#include "harness/report/evaluation/resolution_study.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "harness/plan/plan.hpp"
#include "harness/records/record_json.hpp"
#include "harness/report/evaluation/outcome.hpp"

namespace signorini {

namespace {

Eligibility eligibility_of(const std::vector<ScoredRun>& runs) {
  const auto other = [](const ScoredRun& run) { return has_another_law(*run.record); };
  if (std::ranges::any_of(runs, other)) return Eligibility::another_law;
  const auto refuses = [](const ScoredRun& run) { return run.record->status == Status::not_applicable; };
  return std::ranges::all_of(runs, refuses) ? Eligibility::not_applicable : Eligibility::ranked;
}

/// A configuration that does not apply says no law: where it has another one on scenes of the same law, it
/// would have it here too.
void take_laws_from_other_scenes(std::vector<ResolutionStudy>& studies) {
  const auto key_of = [](const ResolutionStudy& study) {
    const std::optional<RepresentedLaw>& law = study.runs.front().record->scene_law;
    return std::pair(study.configuration, law ? JsonForm<RepresentedLaw>::write(*law).dump() : std::string());
  };
  std::set<std::pair<std::string, std::string>> other;
  for (const ResolutionStudy& study : studies) {
    if (study.eligibility == Eligibility::another_law) other.insert(key_of(study));
  }
  for (ResolutionStudy& study : studies) {
    if (study.eligibility == Eligibility::not_applicable && other.contains(key_of(study)))
      study.eligibility = Eligibility::another_law;
  }
}

}  // namespace

bool is_numeric(const std::string& value) {
  char* end = nullptr;
  std::strtod(value.c_str(), &end);
  return !value.empty() && end == value.c_str() + value.size();
}

std::string configuration_of(const Record& record) {
  Settings words = record.settings;
  std::erase_if(words, [](const OptionSetting& setting) {
    return setting.first != kStartSetting && is_numeric(setting.second);
  });
  return method_label(record.method, words);
}

ScoredRun scored_run(const Record& record) {
  ScoredRun run{.record = &record};
  run.error = certified_error(record);
  run.bounded = run.error && *recorded_error(record) < *run.error;
  return run;
}

std::ptrdiff_t solved_runs(const ResolutionStudy& study) {
  return std::ranges::count_if(study.runs, [](const ScoredRun& run) { return run.error.has_value(); });
}

std::vector<ResolutionStudy> resolution_studies(const std::vector<Record>& records) {
  std::vector<ResolutionStudy> studies;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (const Record& record : records) {
    const std::string configuration = configuration_of(record);
    const auto [place, fresh] = places.try_emplace({record.scene, configuration}, studies.size());
    if (fresh) studies.push_back({.scene = record.scene, .configuration = configuration});
    studies[place->second].runs.push_back(scored_run(record));
  }
  for (ResolutionStudy& study : studies) study.eligibility = eligibility_of(study.runs);
  take_laws_from_other_scenes(studies);
  return studies;
}

}  // namespace signorini
