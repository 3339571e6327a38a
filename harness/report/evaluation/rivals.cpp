#include "harness/report/evaluation/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

namespace signorini {

namespace {

const CaseChoice& choice_of(const ResolutionStudy& study) { return *study.runs.front().result->choice; }

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
  const auto [seconds, run] = cost_to_error(study, time_axis(), error);
  ++times.scenes;
  if (run == nullptr) return;
  ++times.reached;
  if (const auto is_stable = run->result->outcome.stable) ++(*is_stable ? times.stable : times.unstable);
  if (std::isfinite(least.own) && least.own > 0.0 && seconds > 0.0) {
    times.to_own.push_back(seconds / least.own);
    if (const std::optional<long> points = run->result->work.points; points && *points > 0) {
      times.points.push_back(*points);
      times.per_point.push_back(times.to_own.back() / static_cast<double>(*points));
    }
  }
  if (std::isfinite(least.plain) && least.plain > 0.0 && seconds > 0.0)
    times.to_plain.push_back(seconds / least.plain);
  if (least.is_fastest(study.configuration)) ++times.fastest;
}

}  // namespace

std::vector<Rival> rivals(const Evaluation& evaluation) {
  std::map<std::string, Rival> found;
  for (const std::string& scene : evaluation.scenes()) {
    if (evaluation.is_contact_free(scene)) continue;
    const std::span<const ResolutionStudy> studies = evaluation.studies_of(scene);
    for (std::size_t e = 0; e < kRivalErrors.size(); ++e) {
      const LeastTimes least = least_times(studies, kRivalErrors[e]);
      for (const ResolutionStudy& study : studies) {
        if (study.eligibility != Eligibility::ranked || !choice_of(study).from_plugin ||
            evaluation.is_repeated(study))
          continue;
        Rival& rival = found[study.configuration];
        rival.configuration = study.configuration;
        add(least, study, kRivalErrors[e], rival.at[e]);
      }
    }
  }
  std::vector<Rival> result;
  for (auto& [configuration, rival] : found) {
    for (RivalTimes& times : rival.at) {
      std::ranges::sort(times.to_own);
      std::ranges::sort(times.to_plain);
      std::ranges::sort(times.per_point);
      std::ranges::sort(times.points);
    }
    result.push_back(std::move(rival));
  }
  return result;
}

}  // namespace signorini
