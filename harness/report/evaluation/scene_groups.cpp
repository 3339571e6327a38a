#include "harness/report/evaluation/scene_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <variant>

#include "harness/table.hpp"

namespace signorini {

namespace {

std::optional<SceneKind> kind_of_law(const RepresentedLaw& law) {
  if (const auto* rigid = std::get_if<Restitution>(&law))
    return rigid->e == 1.0 ? SceneKind::rigid_stop : SceneKind::restitution;
  if (std::holds_alternative<Penalty>(law)) return SceneKind::spring;
  if (std::holds_alternative<Massless>(law)) return SceneKind::massless;
  return std::nullopt;
}

const Reach& ranking_reach(const Standing& standing) { return standing.reach[kRankingError]; }

bool stands_before(const Standing& a, const Standing& b) {
  const Reach &first = ranking_reach(a), &second = ranking_reach(b);
  if (first.scenes != second.scenes) return first.scenes > second.scenes;
  const double sooner = first.median_seconds(), later = second.median_seconds();
  return sooner != later ? sooner < later : natural_less(a.configuration, b.configuration);
}

void rank_standings(SceneGroup& group) {
  std::ranges::sort(group.standings, stands_before);
  if (group.standings.empty()) return;
  const Reach& best = ranking_reach(group.standings.front());
  if (best.scenes == 0) return;
  for (Standing& standing : group.standings) {
    const Reach& reach = ranking_reach(standing);
    standing.recommended =
        reach.scenes == best.scenes && reach.median_seconds() <= kEqualTimes * best.median_seconds();
  }
}

/// Scenes that a configuration has no part in count as not reached.
void count_the_rest(SceneGroup& group) {
  for (Standing& standing : group.standings) {
    for (Reach& reach : standing.reach) reach.seconds.resize(group.scenes.size(), kNeverReached);
  }
}

}  // namespace

std::string_view kind_title(SceneKind kind) {
  switch (kind) {
    case SceneKind::rigid_stop:
      return "Rigid stop (e = 1)";
    case SceneKind::restitution:
      return "Restitution (e < 1)";
    case SceneKind::spring:
      return "Spring";
    case SceneKind::massless:
      return "Massless contact";
    case SceneKind::many_contacts:
      return "Many contacts (5 or more)";
    case SceneKind::large_structure:
      return "Large structure (100 coordinates or more)";
  }
  return {};
}

std::optional<SceneKind> kind_of_scene(const std::optional<RepresentedLaw>& law,
                                       std::optional<int> coordinates, std::optional<int> contacts) {
  const std::optional<SceneKind> by_law = law ? kind_of_law(*law) : std::nullopt;
  if (!by_law) return std::nullopt;
  if (coordinates >= kLargeStructure) return SceneKind::large_structure;
  if (contacts >= kManyContacts) return SceneKind::many_contacts;
  return by_law;
}

std::optional<SceneKind> kind_of(const CaseScene& scene) {
  return kind_of_scene(scene.law, scene.coordinates, scene.contacts);
}

std::vector<SceneGroup> scene_groups(const Evaluation& evaluation) {
  std::map<std::string_view, SceneKind> kinds;  // by scene
  for (const CaseResult& result : evaluation.results()) {
    if (const std::optional<SceneKind> kind = kind_of(*result.scene))
      kinds.try_emplace(result.scene->name, *kind);
  }
  std::map<SceneKind, SceneGroup> groups;
  for (const std::string& scene : evaluation.scenes()) {
    const auto kind = kinds.find(scene);
    if (kind == kinds.end()) continue;
    if (!evaluation.is_ranked(scene)) {
      kinds.erase(kind);
      continue;
    }
    groups[kind->second].kind = kind->second;
    groups[kind->second].scenes.push_back(scene);
  }
  for (const ResolutionStudy& study : evaluation.studies()) {
    const auto kind = kinds.find(study.scene);
    if (kind == kinds.end() || study.eligibility != Eligibility::ranked) continue;
    std::vector<Standing>& standings = groups[kind->second].standings;
    auto standing = std::ranges::find(standings, study.configuration, &Standing::configuration);
    if (standing == standings.end()) {
      standing = standings.insert(standings.end(), {.configuration = study.configuration,
                                                    .method = study.runs.front().result->choice->method});
    }
    for (std::size_t i = 0; i < kGroupErrors.size(); ++i) standing->reach[i].add(study, kGroupErrors[i]);
  }
  std::vector<SceneGroup> result;
  for (auto& [kind, group] : groups) {
    count_the_rest(group);
    rank_standings(group);
    result.push_back(std::move(group));
  }
  return result;
}

}  // namespace signorini
