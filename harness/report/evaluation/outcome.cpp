#include "harness/report/evaluation/outcome.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace signorini {

bool has_another_law(const Record& record) { return record.law_matches_scene == false; }

bool is_solved(const Record& record) {
  return claim_of(record) == Claim::certified && !has_another_law(record);
}

std::vector<bool> repeated_problems(const std::vector<Record>& records) {
  std::vector<bool> repeated(records.size(), false);
  std::set<std::pair<std::string, std::string>> seen;  // resolution and problem
  for (const bool another_law : {false, true}) {
    for (std::size_t i = 0; i < records.size(); ++i) {
      const Record& record = records[i];
      if (record.problem.empty() || has_another_law(record) != another_law) continue;
      repeated[i] = !seen.emplace(resolution_of(record), record.problem).second;
    }
  }
  return repeated;
}

Measure recorded_error(const Record& record) {
  return record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
}

Measure bounded_error(const Record& record) {
  const Measure error = recorded_error(record);
  return error ? std::max(*error, measurable_error(record)) : error;
}

Measure certified_error(const Record& record) {
  return claim_of(record) == Claim::certified ? bounded_error(record) : std::nullopt;
}

void OutcomeCounts::add(const Record& record) {
  const std::optional<Claim> claim = claim_of(record);
  const bool refused = record.status == Status::not_applicable;
  ++cases;
  not_applicable += refused ? 1 : 0;
  failed += !claim && !refused ? 1 : 0;
  refuted += claim == Claim::refuted ? 1 : 0;
  unproven += claim == Claim::unproven ? 1 : 0;
  another_law += !refused && has_another_law(record) ? 1 : 0;
  solved += is_solved(record) ? 1 : 0;
  if (claim != Claim::certified) return;
  ++certified;
  if (const auto same = record.certificate.same_orbit) ++(*same ? same_orbit : other_orbit);
}

}  // namespace signorini
