#include "harness/report/evaluation/outcome.hpp"

#include <algorithm>

namespace signorini {

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
  if (claim != Claim::certified) return;
  ++certified;
  if (const auto same = record.certificate.same_orbit) ++(*same ? same_orbit : other_orbit);
}

}  // namespace signorini
