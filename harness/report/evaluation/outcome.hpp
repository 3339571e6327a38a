#pragma once
// What became of cases, by which every table counts, ranks and averages. Solved is what claim_of calls
// certified.

#include "harness/records/record.hpp"

namespace signorini {

/// Relative L2 error of x, of u where the scene has no contact. Whether its orbit certifies the answer is not
/// asked.
Measure recorded_error(const Record& record);

/// recorded_error, but not below ten error bars of the orbit.
Measure bounded_error(const Record& record);

/// bounded_error of a certified answer; empty for all others.
Measure certified_error(const Record& record);

/// How many cases ended how.
struct OutcomeCounts {
  int cases = 0, not_applicable = 0, failed = 0, refuted = 0, unproven = 0, certified = 0;
  int same_orbit = 0, other_orbit = 0;  ///< certified, and the orbit reached from rest or another one

  void add(const Record& record);
  [[nodiscard]] int applicable() const { return cases - not_applicable; }
  /// Claims that are not refuted.
  [[nodiscard]] int converged() const { return certified + unproven; }
  [[nodiscard]] int claims() const { return converged() + refuted; }
};

}  // namespace signorini
