#pragma once
// What the records of a method's ladder on a scene say of its promises: the harness's own verdicts, as in a
// run.

#include <span>
#include <vector>

#include "harness/conformance/finding.hpp"
#include "harness/plan/selection.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// The records of one method on one scene, one per step of its ladder, all of which it was asked.
struct LadderRecords {
  const MethodEntry& entry;
  std::vector<Settings> ladder;
  std::vector<Record> records;  ///< as many
};

struct LadderCheck {
  std::string_view name;
  std::string_view promise;
  CheckResult (*examine)(const LadderRecords& ladder);
};

/// Every step that applies converges.
CheckResult check_convergence(const LadderRecords& ladder);
/// No answer that is called converged is refuted: by its certificate, by being no trajectory, or by a crash.
CheckResult check_certificate(const LadderRecords& ladder);
/// The error of x against the certified orbits under the law that the method declares falls as it declares.
CheckResult check_order(const LadderRecords& ladder);

std::span<const LadderCheck> ladder_checks();

}  // namespace signorini
