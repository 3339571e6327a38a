#include "harness/report/evaluation/scene_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "harness/table.hpp"

namespace signorini {

namespace {

/// Titles and words, in the order of SceneKind.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kKinds{
    {{"Rigid stop (e = 1)", "rigid stops"},
     {"Restitution (e < 1)", "restitution"},
     {"Spring", "springs"},
     {"Massless contact", "massless contacts"},
     {"Mixed laws", "contacts of different laws"},
     {"Many contacts (5 or more)", "many contacts"},
     {"Large structure (100 coordinates or more)", "large structures"},
     {"Motion without contact", "motions without contact"}}};

std::optional<SceneKind> kind_of_law(const RepresentedLaw& law) {
  if (const auto* rigid = std::get_if<Restitution>(&law))
    return rigid->e == 1.0 ? SceneKind::rigid_stop : SceneKind::restitution;
  if (std::holds_alternative<Penalty>(law)) return SceneKind::spring;
  if (std::holds_alternative<Massless>(law)) return SceneKind::massless;
  if (std::holds_alternative<MixedLaws>(law)) return SceneKind::mixed_laws;
  return std::nullopt;
}

const Reach& ranking_reach(const Standing& standing) { return standing.reach[kRankingError]; }

bool stands_before(const Standing& a, const Standing& b) {
  const Reach &first = ranking_reach(a), &second = ranking_reach(b);
  if (first.lasting() != second.lasting()) return first.lasting() > second.lasting();
  if (first.scenes != second.scenes) return first.scenes > second.scenes;
  const double sooner = first.median_seconds(), later = second.median_seconds();
  return sooner != later ? sooner < later : natural_less(a.configuration, b.configuration);
}

/// A standing with the studies that it is made of, by scene.
struct Contestant {
  Standing standing;
  std::vector<const ResolutionStudy*> studies = {};

  /// Whether its equations are those of another one wherever it has an answer.
  [[nodiscard]] bool has_equations_of(const Contestant& other) const {
    bool any = false;
    for (const ResolutionStudy* study : studies) {
      for (const ScoredRun& run : study->runs) {
        if (!run.error) continue;
        any = true;
        const auto is_equal = [&](const ScoredRun& its) {
          return signorini::has_equations_of(*run.result->choice, *its.result->choice);
        };
        if (std::ranges::none_of(other.studies, [&](const ResolutionStudy* its) {
              return its->scene == study->scene && std::ranges::any_of(its->runs, is_equal);
            }))
          return false;
      }
    }
    return any;
  }
};

bool have_equal_equations(const Contestant& a, const Contestant& b) {
  return a.has_equations_of(b) || b.has_equations_of(a);
}

/// Leaves of contestants, best first, with one result the first, which names the others.
void join_equal_results(std::vector<Contestant>& contestants) {
  std::vector<Contestant> joined;
  std::map<std::string, std::size_t> places;  // of answers
  for (Contestant& contestant : contestants) {
    const std::string answers = answers_of(contestant.studies);
    const auto known = answers.empty() ? places.end() : places.find(answers);
    const auto is_same = [&](const Contestant& other) {
      return ranking_reach(other.standing).scenes == ranking_reach(contestant.standing).scenes &&
             have_equal_equations(contestant, other);
    };
    const auto same = known == places.end() ? std::ranges::find_if(joined, is_same)
                                            : joined.begin() + static_cast<std::ptrdiff_t>(known->second);
    if (same != joined.end()) {
      same->standing.same.push_back(contestant.standing.configuration);
      continue;
    }
    if (!answers.empty()) places.emplace(answers, joined.size());
    joined.push_back(std::move(contestant));
  }
  contestants = std::move(joined);
}

/// Recommends as SceneGroup::standings says.
void recommend(std::vector<Contestant>& contestants) {
  Standing& first = contestants.front().standing;
  const Reach& best = ranking_reach(first);
  if (best.lasting() == 0) return;
  const double least = best.median_seconds();
  Contestant* sooner = nullptr;
  bool others = false;
  for (Contestant& contestant : contestants) {
    Standing& standing = contestant.standing;
    const Reach& reach = ranking_reach(standing);
    const double seconds = reach.median_seconds();
    if (reach.lasting() == best.lasting()) {
      others = others || &standing != &first;
      standing.recommended = seconds <= kEqualTimes * least;
      if (&standing != &first) standing.reason = "as many scenes, within 10 %";
    } else if (reach.lasting() > 0 && reach.lasting() + 1 == best.lasting() &&
               kEqualTimes * seconds < least &&
               (sooner == nullptr || seconds < ranking_reach(sooner->standing).median_seconds()) &&
               !have_equal_equations(contestant, contestants.front())) {
      sooner = &contestant;
    }
  }
  first.reason = others ? "most scenes, fastest" : "most scenes";
  if (sooner == nullptr) return;
  sooner->standing.recommended = true;
  const double seconds = ranking_reach(sooner->standing).median_seconds();
  sooner->standing.reason =
      std::isfinite(least) ? fmt::format("one stable motion fewer, {:.2g} times as fast", least / seconds)
                           : std::string("one stable motion fewer, timed");
}

/// Puts the contestants in order into their group.
void rank_contestants(std::vector<Contestant> contestants, SceneGroup& group) {
  // Scenes that a configuration has no part in count as not reached.
  for (Contestant& contestant : contestants)
    for (Reach& reach : contestant.standing.reach) reach.seconds.resize(group.scenes.size(), kNeverReached);
  std::ranges::sort(contestants, stands_before, &Contestant::standing);
  join_equal_results(contestants);
  if (!contestants.empty() && !group.is_too_small()) recommend(contestants);
  for (Contestant& contestant : contestants) group.standings.push_back(std::move(contestant.standing));
}

}  // namespace

std::string_view kind_title(SceneKind kind) { return kKinds.at(static_cast<std::size_t>(kind)).first; }

std::string_view kind_words(SceneKind kind) { return kKinds.at(static_cast<std::size_t>(kind)).second; }

std::optional<SceneKind> kind_of(const CaseScene& scene) {
  const std::optional<SceneKind> by_law = scene.law ? kind_of_law(*scene.law) : std::nullopt;
  if (!by_law || by_law == SceneKind::mixed_laws) return by_law;
  if (scene.coordinates >= kLargeStructure) return SceneKind::large_structure;
  return scene.contacts >= kManyContacts ? SceneKind::many_contacts : by_law;
}

std::optional<SceneKind> kind_of(const Evaluation& evaluation, const std::string& scene) {
  if (evaluation.is_contact_free(scene)) return SceneKind::contact_free;
  for (const CaseResult& result : evaluation.results_of(scene))
    if (const std::optional<SceneKind> kind = kind_of(*result.scene)) return kind;
  return std::nullopt;
}

std::string Standing::names() const {
  std::string text = configuration;
  for (const std::string& other : same) text += " = " + other;
  return text;
}

std::vector<SceneGroup> scene_groups(const Evaluation& evaluation) {
  std::map<std::string_view, SceneKind> kinds;  // by scene
  std::map<SceneKind, SceneGroup> groups;
  std::map<SceneKind, std::vector<Contestant>> contestants;
  for (const std::string& scene : evaluation.scenes()) {
    const std::optional<SceneKind> kind = kind_of(evaluation, scene);
    if (!kind || !evaluation.is_ranked(scene)) continue;
    kinds.emplace(scene, *kind);
    groups[*kind].kind = *kind;
    groups[*kind].scenes.push_back(scene);
  }
  for (const ResolutionStudy& study : evaluation.studies()) {
    const auto kind = kinds.find(study.scene);
    if (kind == kinds.end() || study.eligibility != Eligibility::ranked) continue;
    std::vector<Contestant>& of_kind = contestants[kind->second];
    auto place = std::ranges::find(of_kind, study.configuration, [](const Contestant& contestant) {
      return contestant.standing.configuration;
    });
    if (place == of_kind.end())
      place = of_kind.insert(of_kind.end(), {.standing = {.configuration = study.configuration,
                                                          .method = choice_of(study).method}});
    for (std::size_t i = 0; i < kGroupErrors.size(); ++i)
      place->standing.reach[i].add(study, kGroupErrors[i]);
    place->studies.push_back(&study);
  }
  std::vector<SceneGroup> result;
  for (auto& [kind, group] : groups) {
    rank_contestants(std::move(contestants[kind]), group);
    result.push_back(std::move(group));
  }
  return result;
}

}  // namespace signorini
