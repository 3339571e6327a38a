#include "harness/report/evaluation/resolution_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "harness/plan/case_name.hpp"
#include "harness/records/record_json.hpp"
#include "harness/statistics.hpp"
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

/// Numbers in rising order; words as they ran.
void put_in_order(std::vector<std::string>& values) {
  const auto is_number = [](const std::string& value) { return number_in(value).has_value(); };
  if (std::ranges::all_of(values, is_number)) std::ranges::stable_sort(values, {}, number_in);
}

}  // namespace

ScoredRun scored_run(const CaseResult& result) {
  ScoredRun run{.result = &result};
  run.error = certified_level(result);
  run.bounded = run.error && *result.level < *run.error;
  return run;
}

const CaseChoice& choice_of(const ResolutionStudy& study) { return *study.runs.front().result->choice; }

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

std::string answers_of(const std::vector<const ResolutionStudy*>& studies) {
  std::string text;
  for (const ResolutionStudy* study : studies) {
    const std::string answers = answers_of(*study);
    if (answers.empty() && claimed_runs(*study) > 0) return {};
    if (!answers.empty()) text += study->scene + " " + answers;
  }
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

std::ptrdiff_t claimed_runs(const ResolutionStudy& study) {
  return std::ranges::count_if(
      study.runs, [](const ScoredRun& run) { return claim_of(run.result->outcome).has_value(); });
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

std::map<Varied, Variation> variations_of(std::span<const CaseResult> results) {
  std::map<Varied, Variation> variations;
  for (const CaseResult& result : results) {
    const CaseChoice& choice = *result.choice;
    for (std::size_t varied = 0; varied < choice.settings.size(); ++varied) {
      Settings others = choice.settings;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(varied));
      const auto numeric = [](const OptionSetting& setting) { return is_numeric(setting.second); };
      if (std::none_of(others.begin(), others.end(), numeric)) continue;
      const auto& [option, value] = choice.settings[varied];
      Variation& variation = variations[{method_label(choice.method, others), option}];
      std::vector<const CaseResult*>& at_value = variation.results[value];
      if (at_value.empty()) variation.values.push_back(value);
      at_value.push_back(&result);
    }
  }
  for (auto& [varied, variation] : variations) put_in_order(variation.values);
  return variations;
}

std::optional<double> number_in(const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const std::string_view rest = end;
  if (end == value.c_str() || !(rest.empty() || rest == "x")) return std::nullopt;
  return number;
}

const CostAxis& time_axis() {
  static const CostAxis axis{
      "time", [](const CaseResult& result) -> std::optional<double> { return result.seconds; }};
  return axis;
}

std::span<const CostAxis> work_axes() {
  using Cost = std::optional<double>;
  static const std::array<CostAxis, 5> axes{
      {{"pivots", [](const CaseResult& r) -> Cost { return r.work.pivots; }},
       {"iterations", [](const CaseResult& r) -> Cost { return r.work.iterations; }},
       {"right-hand sides", [](const CaseResult& r) -> Cost { return r.work.rhs_evaluations; }},
       {"factorisations", [](const CaseResult& r) -> Cost { return r.work.factorisations; }},
       {"unknowns", [](const CaseResult& r) -> Cost { return r.work.unknowns; }}}};
  return axes;
}

std::vector<CurvePoint> pareto_curve(const ResolutionStudy& study, const CostAxis& axis) {
  std::vector<CurvePoint> points;
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> cost = axis.cost(*run.result);
    if (run.error && cost) points.push_back({*cost, &run});
  }
  std::stable_sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : *a.run->error < *b.run->error;
  });
  std::vector<CurvePoint> curve;
  for (const CurvePoint& point : points) {
    const bool better = curve.empty() || (*point.run->error < *curve.back().run->error &&
                                          !(point.run->bounded && curve.back().run->bounded));
    if (better) curve.push_back(point);
  }
  return curve;
}

CurvePoint cost_to_error(const ResolutionStudy& study, const CostAxis& axis, double error) {
  for (const CurvePoint& point : pareto_curve(study, axis)) {
    if (*point.run->error <= error) return point;
  }
  return {kNeverReached, nullptr};
}

const ScoredRun* reaching_run(const ResolutionStudy& study, double error) {
  if (const ScoredRun* cheapest = cost_to_error(study, time_axis(), error).run) return cheapest;
  const auto first = std::ranges::find_if(
      study.runs, [&](const ScoredRun& run) { return run.error && *run.error <= error; });
  return first == study.runs.end() ? nullptr : &*first;
}

void Reach::add(const ResolutionStudy& study, double error) {
  if (const ScoredRun* run = reaching_run(study, error)) {
    ++scenes;
    if (const auto is_stable = run->result->outcome.stable) ++(*is_stable ? stable : unstable);
  }
  seconds.push_back(cost_to_error(study, time_axis(), error).cost);
}

double Reach::median_seconds() const { return seconds.empty() ? kNeverReached : median(seconds); }

}  // namespace signorini
