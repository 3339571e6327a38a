#include "harness/report/evaluation/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "harness/statistics.hpp"

namespace signorini {

namespace {

/// The least times on a scene to an error, infinite where it is not reached.
struct LeastTimes {
  double own = kNeverReached, plain = kNeverReached;
  std::map<std::string, double> of = {};  ///< each configuration

  /// Whether no other configuration is as fast.
  [[nodiscard]] bool is_fastest(const std::string& configuration) const {
    const double seconds = of.at(configuration);
    return std::isfinite(seconds) && std::ranges::all_of(of, [&](const auto& other) {
             return other.first == configuration || other.second > seconds;
           });
  }
};

LeastTimes least_times(std::span<const ResolutionStudy> studies, double error) {
  LeastTimes least;
  for (const ResolutionStudy& study : studies) {
    if (study.eligibility != Eligibility::ranked) continue;
    const double seconds = cost_to_error(study, time_axis(), error).cost;
    least.of[study.configuration] = seconds;
    const CaseChoice& choice = choice_of(study);
    if (choice.from_plugin) continue;
    double& kind = choice.is_plain() ? least.plain : least.own;
    kind = std::min(kind, seconds);
  }
  return least;
}

void add(const LeastTimes& least, const ResolutionStudy& study, double error, RivalTimes& times) {
  const CurvePoint cost = cost_to_error(study, time_axis(), error);
  const double seconds = cost.cost;
  const ScoredRun* const run = cost.run;
  ++times.scenes;
  if (run == nullptr) return;
  ++times.reached;
  if (const auto is_stable = run->result->outcome.stable) ++(*is_stable ? times.stable : times.unstable);
  const auto comparable = [&](double other) { return std::isfinite(other) && other > 0.0 && seconds > 0.0; };
  if (comparable(least.own)) {
    times.to_own.push_back(seconds / least.own);
    if (const long points = run->result->work.points.value_or(0); points > 0) {
      times.points.push_back(points);
      times.per_point.push_back(times.to_own.back() / static_cast<double>(points));
    }
  }
  if (comparable(least.plain)) times.to_plain.push_back(seconds / least.plain);
  if (least.is_fastest(study.configuration)) ++times.fastest;
}

}  // namespace

std::vector<Rival> rivals(const Evaluation& evaluation) {
  std::map<std::string, Rival> found;
  for (const std::string& scene : evaluation.scenes()) {
    if (evaluation.is_contact_free(scene)) continue;
    const std::span<const ResolutionStudy> studies = evaluation.studies_of(scene);
    for (std::size_t e = 0; e < kHeadlineErrors.size(); ++e) {
      const LeastTimes least = least_times(studies, kHeadlineErrors[e]);
      for (const ResolutionStudy& study : studies) {
        if (study.eligibility != Eligibility::ranked || !choice_of(study).from_plugin ||
            evaluation.is_repeated(study))
          continue;
        Rival& rival = found[study.configuration];
        rival.configuration = study.configuration;
        add(least, study, kHeadlineErrors[e], rival.at[e]);
      }
    }
  }
  std::vector<Rival> result;
  for (auto& [configuration, rival] : found) {
    for (RivalTimes& times : rival.at) {
      for (auto* ratios : {&times.to_own, &times.to_plain, &times.per_point}) std::ranges::sort(*ratios);
      std::ranges::sort(times.points);
    }
    result.push_back(std::move(rival));
  }
  return result;
}

std::vector<HandOver> hand_overs(const Evaluation& evaluation) {
  std::vector<std::pair<std::vector<double>, std::vector<double>>> times(evaluation.configurations().size());
  for (const CaseResult& result : evaluation.results()) {
    if (!result.seconds || !result.exchange) continue;
    auto& [own, beside] = times[evaluation.place_of(result.choice->configuration)];
    own.push_back(*result.seconds);
    beside.push_back(*result.exchange);
  }
  std::vector<HandOver> found;
  for (std::size_t place = 0; place < times.size(); ++place) {
    const auto& [own, beside] = times[place];
    if (own.empty()) continue;
    found.push_back({.configuration = evaluation.configurations()[place],
                     .cases = static_cast<int>(own.size()),
                     .own = median(own),
                     .beside = median(beside)});
  }
  return found;
}

}  // namespace signorini
