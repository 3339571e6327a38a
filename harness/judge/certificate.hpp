#pragma once
// Is there a true orbit near an answer, and which?

#include <memory>
#include <optional>

#include "harness/judge/measures/motion.hpp"
#include "harness/judge/reference.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// An orbit this near to an answer, in x, may certify it; see `distance`.
inline constexpr double kOwnOrbit = 0.1;

/// The certificate of an answer, and the orbit that its errors are measured against.
struct CertifiedAnswer {
  Certificate certificate;
  std::optional<Motion> orbit = {};  ///< at the answer's own phase; of one that is only near, too
};

/// Looks for the orbit of `problem` (under the law that the answer represents) behind an answer, from the
/// answer and from nothing else, beginning at its quiet instants wherever its period begins:
///
/// 1. the exact orbit that the answer polishes to, confirmed by CVODE; of large structures on a reduced one,
///    corrected by the response of the whole (`exact_orbits`)
/// 2. shooting at 1e-11 from the answer, from up to four of its instants, repeated at 1e-12 for the error bar
///
/// The answer is certified by an orbit whose error bar is at most 1e-6, which lies within kOwnOrbit, and
/// whose contacts are the answer's (`contact_difference`). Else it is uncertified. It is refuted where the
/// nearest orbit found is farther away than kNearOrbit, or contradicts the answer's contacts; and where none
/// is found and the answer is off the equations of its own scene (`equation_defect`) by more than an answer
/// near an orbit is, less where the reference is known to be far away, not at all where it is near. Not so
/// where another orbit is near, or a motion that lacks nothing but its confirmation
/// (CertifiedOrbit::unconfirmed). `distance` is that of the nearest of all these. An answer without contact
/// coordinates is certified by any orbit. A reference certifies nothing; it tells whether the orbit is the
/// one that is reached from rest.
///
/// \param answer  what the method returned
/// \param motion  the same, sampled by `sample_answer`
CertifiedAnswer certify(const Problem& problem, std::shared_ptr<const Trajectory> answer,
                        const Motion& motion, const Reference& reference, const OrbitTools& tools,
                        Deadline deadline);

/// The status that the harness gives: `inaccurate` where the method says converged, but penetrates a rigid
/// stop by more than half the amplitude, is off the law of contact by as much in the mean over time
/// (`Physics::complementarity`), or its certificate holds a refutation.
void apply_verdict(Record& record);

/// What an answer near an orbit cannot be off by; see `equation_defect`.
struct EquationDefect {
  double motion = 0.0;       ///< of the equation of motion, relative to the size of x [-]
  double penetration = 0.0;  ///< of the stops, in amplitudes [-]
};

/// What is left of two defects of an answer after what its coarseness may explain:
///
/// - motion: |x - r(lambda)| less a tenth of |r(lambda) - r(0)| and of |r(0) - mean r(0)|, over |x - mean x|,
///   root mean squares over time and contacts, r(lambda) the structure's periodic response to its load and
///   lambda. The tenth stands for the error of the force, which a resonance magnifies.
/// - penetration: the largest x - g, of a spring less -lambda / k, beyond twice what x moves by in the
///   answer's resolution in time (that of its bandwidth or nodes, at most a twentieth of the forcing period),
///   over the amplitude.
///
/// The size of x and its amplitude are at least Motion::least. A defect that the structure has no unique
/// response for, or no scale, is 0.
/// \param answer  with its `least`
/// \param spaces  of large structures, for their responses
EquationDefect equation_defect(const Problem& problem, const Motion& answer, KeptSpace& spaces);

}  // namespace signorini
