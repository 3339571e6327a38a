#pragma once
// Does a true orbit stand behind an answer, and which?

#include <memory>

#include "harness/judge/reference.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// An orbit farther from an answer than this, relative x_l2, does not stand behind it.
inline constexpr double kNearOrbit = 0.5;

/// The certificate of an answer, and the orbit that its errors are measured against.
struct Judgement {
  Certificate certificate;
  std::optional<Motion> orbit = {};  ///< none unless certified
  int shift = 0;                     ///< of the orbit against the answer, in forcing periods
};

/// Looks for an orbit of `problem` (under the law that the answer represents) behind an answer, of which
/// `motion` holds the samples:
///
/// 1. the exact orbit that the answer polishes to, confirmed by CVODE
/// 2. where there is none, shooting at 1e-11 from the answer, repeated at 1e-12 for the error bar
/// 3. where that finds none within kNearOrbit either, the reference of that law
///
/// An orbit within kNearOrbit certifies the answer.
///
/// Otherwise uncertified, with the reason. `distance` is that of the orbit nearest to the answer, if any was
/// found. An answer without contact coordinates is certified by an orbit of the structure.
Judgement certify(const Problem& problem, std::shared_ptr<const Trajectory> answer, const Motion& motion,
                  const Reference& reference, const OrbitTools& tools,
                  std::chrono::steady_clock::time_point deadline);

/// The status that the harness gives: `inaccurate` where the method says converged, but penetrates a rigid
/// stop by more than half the amplitude, or the orbit found from its answer is farther away than kNearOrbit.
void apply_verdict(Record& record);

}  // namespace signorini
