#pragma once
// Is there a true orbit near an answer, and which?

#include <memory>
#include <optional>

#include "harness/judge/motion.hpp"
#include "harness/judge/reference.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// The certificate of an answer, and the orbit that its errors are measured against.
struct CertifiedAnswer {
  Certificate certificate;
  std::optional<Motion> orbit = {};  ///< none unless certified
  int shift = 0;                     ///< of the orbit against the answer, in forcing periods
};

/// Looks for an orbit of `problem` (under the law that the answer represents) near an answer. These attempts
/// are made in turn until one finds an orbit within kNearOrbit whose error bar is at most 1e-6:
///
/// 1. the exact orbit that the answer polishes to, confirmed by CVODE
/// 2. shooting at 1e-11 from the answer, repeated at 1e-12 for the error bar
/// 3. the reference of that law, shifted by whole forcing periods
///
/// If all fail the answer is uncertified, and the reason is that of the attempts; `distance` is that of the
/// nearest orbit that any of them found. An answer without contact coordinates is certified by any orbit.
///
/// \param answer  what the method returned
/// \param motion  the same, sampled
CertifiedAnswer certify(const Problem& problem, std::shared_ptr<const Trajectory> answer,
                        const Motion& motion, const Reference& reference, const OrbitTools& tools,
                        Deadline deadline);

/// The status that the harness gives: `inaccurate` where the method says converged, but penetrates a rigid
/// stop by more than half the amplitude, or the orbit found from its answer is farther away than kNearOrbit.
void apply_verdict(Record& record);

}  // namespace signorini
