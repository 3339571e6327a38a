#include "harness/report/evaluation/outcome.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace signorini {

std::optional<Claim> claim_of(const CaseOutcome& outcome) {
  return outcome.response ? std::nullopt : claim_of(outcome.status, outcome.certificate);
}

bool has_another_law(const CaseOutcome& outcome) { return outcome.law_matches_scene == false; }

bool is_solved(const CaseOutcome& outcome) {
  return claim_of(outcome) == Claim::certified && !has_another_law(outcome);
}

std::vector<bool> repeated_problems(const std::vector<CaseResult>& results) {
  std::vector<bool> repeated(results.size(), false);
  std::set<std::pair<std::string_view, std::string_view>> seen;  // resolution and problem
  for (const bool another_law : {false, true}) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const CaseResult& result = results[i];
      if (result.problem == nullptr || has_another_law(result.outcome) != another_law) continue;
      repeated[i] = !seen.emplace(result.choice->resolution, *result.problem).second;
    }
  }
  return repeated;
}

Measure bounded_error(const CaseResult& result) {
  return result.error ? std::max(*result.error, result.measurable) : result.error;
}

Measure certified_error(const CaseResult& result) {
  return claim_of(result.outcome) == Claim::certified ? bounded_error(result) : std::nullopt;
}

Measure certified_level(const CaseResult& result) {
  if (claim_of(result.outcome) != Claim::certified || !result.level) return std::nullopt;
  return std::max(*result.level, result.measurable);
}

void OutcomeCounts::add(const CaseOutcome& outcome) {
  const std::optional<Claim> claim = claim_of(outcome);
  const bool refused = outcome.status == Status::not_applicable;
  ++cases;
  not_applicable += refused ? 1 : 0;
  const bool is_followed = outcome.response && outcome.status == Status::converged;
  followed += is_followed ? 1 : 0;
  failed += !claim && !refused && !is_followed ? 1 : 0;
  refuted += claim == Claim::refuted ? 1 : 0;
  unproven += claim == Claim::unproven ? 1 : 0;
  another_law += !refused && has_another_law(outcome) ? 1 : 0;
  solved += is_solved(outcome) ? 1 : 0;
  if (claim != Claim::certified) return;
  ++certified;
  if (const auto same = outcome.same_orbit) ++(*same ? same_orbit : other_orbit);
  if (outcome.stable) ++(*outcome.stable ? stable : unstable);
}

}  // namespace signorini
