#include "harness/report/evaluation/resolution_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "harness/records/record_json.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

Eligibility eligibility_of(const std::vector<ScoredRun>& runs) {
  const auto other = [](const ScoredRun& run) { return has_another_law(run.result->outcome); };
  if (std::ranges::any_of(runs, other)) return Eligibility::another_law;
  const auto refuses = [](const ScoredRun& run) {
    return run.result->outcome.status == Status::not_applicable;
  };
  return std::ranges::all_of(runs, refuses) ? Eligibility::not_applicable : Eligibility::ranked;
}

/// A configuration that does not apply says no law: where it has another one on scenes of the same law, it
/// would have it here too.
void take_laws_from_other_scenes(std::vector<ResolutionStudy>& studies) {
  const auto key_of = [](const ResolutionStudy& study) {
    const std::optional<RepresentedLaw>& law = study.runs.front().result->scene->law;
    return std::pair(study.configuration,
                     law ? json_text(JsonForm<RepresentedLaw>::write(*law)) : std::string());
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

ScoredRun scored_run(const CaseResult& result) {
  ScoredRun run{.result = &result};
  run.error = certified_level(result);
  run.bounded = run.error && *result.level < *run.error;
  return run;
}

bool has_equations_of(const CaseChoice& a, const CaseChoice& b) {
  return b.method == a.same_equations_as && std::ranges::all_of(a.options, [&](const auto& option) {
           const auto other = std::ranges::find(b.options, option.first, &RecordedOptions::value_type::first);
           return other == b.options.end() || other->second == option.second;
         });
}

std::string answers_of(const ResolutionStudy& study) {
  std::multiset<std::string_view> digests;
  for (const ScoredRun& run : study.runs) {
    if (!claim_of(run.result->outcome)) continue;
    if (run.result->answer == nullptr) return {};
    digests.insert(*run.result->answer);
  }
  std::string text;
  for (const std::string_view digest : digests) text.append(digest).append(" ");
  return text;
}

std::string label_of(const ResolutionStudy& study) {
  const RepresentedLaw* law = study.runs.front().result->law;
  if (study.eligibility != Eligibility::another_law || law == nullptr) return study.configuration;
  return fmt::format("{} ({})", study.configuration, law_text(*law));
}

std::ptrdiff_t solved_runs(const ResolutionStudy& study) {
  return std::ranges::count_if(study.runs, [](const ScoredRun& run) { return run.error.has_value(); });
}

std::vector<ResolutionStudy> resolution_studies(const std::vector<CaseResult>& results) {
  std::vector<ResolutionStudy> studies;
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> places;  // names that the results hold
  for (const CaseResult& result : results) {
    const std::string &scene = result.scene->name, &configuration = result.choice->configuration;
    const auto [place, fresh] = places.try_emplace({scene, configuration}, studies.size());
    if (fresh) studies.push_back({.scene = scene, .configuration = configuration});
    studies[place->second].runs.push_back(scored_run(result));
  }
  for (ResolutionStudy& study : studies) study.eligibility = eligibility_of(study.runs);
  take_laws_from_other_scenes(studies);
  return studies;
}

}  // namespace signorini
