#pragma once
// The measures of an answer: its errors and its physics. The harness takes them; no method measures itself.

#include <string>

#include "harness/judge/measures/motion.hpp"
#include "harness/records/record.hpp"
#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Errors of an answer against an orbit: x and x' as `distance` measures them (root mean square, maximum),
/// the impulse of the worst contact relative to the largest impulse of a contact, the contact force where it
/// is a function of time (no impulse in either motion) as a root mean square relative to the orbit's, and u
/// over the whole structure: on a ContactSpace where one is given, else where Nc < Nd <= 10 000 by the
/// responses to the orbit's force and to the difference of both forces, harmonics 0..512. Absent where the
/// unit is zero.
/// \param space  of this problem, for its field; null: none is known
Errors measure_errors(const Problem& problem, const Motion& answer, const Motion& orbit,
                      const ContactSpace* space = nullptr);

struct EnergyDefect {
  Measure value = {};
  std::string reason = {};  ///< why it is absent
};

/// Physics of an answer under the law it represents, on the harness's grid:
///
/// - penetration: largest max(0, x - g) / amplitude
/// - complementarity: mean |min(-lambda / s, g - x)| / amplitude, s the contact's stiffness scale; for a
///   penalty law mean |lambda + k max(0, x - g)| / (k amplitude)
/// - energy_defect: |W_f - W_D - W_loss| / |W_f|, see `energy_defect`
/// - effective_restitution: -v_after / v_before of each impact whose approach speed exceeds 1 % of the
///   largest speed
/// - contact_ratio
///
/// The amplitude is half of (largest - least) x, the largest over contacts, but at least a tenth of the
/// largest distance of the contact-free motion from the stop (a contact may hardly move). What has no scale,
/// or cannot be computed on this structure, is absent; of the energy defect it is said why.
/// \param space  of this problem, for its responses; null: none is known
Physics measure_physics(const Problem& problem, const RepresentedLaw& law, const Motion& answer,
                        const ContactSpace* space = nullptr);

/// |W_f - W_D - W_loss| / |W_f|: work of the load, dissipation by damping, and the loss at impacts that the
/// represented law prescribes for the impulses found:
/// (1 - e) / (2 (1 + e)) p^T G p over impulses p at one instant, G the Delassus matrix; a closing that lasts
/// loses v_before^2 / (2 G_jj) for e < 1. Penalty and massless laws, and e = 1, lose nothing.
///
/// The response being linear, W_f - W_D is minus the work of the contact force. It is that of the response to
/// the force, harmonic by harmonic, whatever the answer's own motion and the events that it lists; the part
/// of W_D beyond the harmonics that are summed is added in closed form for impulses that are listed. Where
/// force and motion are one solution of the equation of motion (Motion::integrated) it is taken from that
/// motion
/// (`contact_work`), exact where forces jump. Absent, with a reason, where W_f is zero, the law is
/// undetermined, or the structure has no response or no Delassus matrix; and of an answer that is not
/// integrated whose rigid contacts hold throughout.
EnergyDefect energy_defect(const Problem& problem, const RepresentedLaw& law, const Motion& answer);

/// Loss at impacts per period that a restitution e prescribes for the phases found [J].
double expected_loss(const Motion& motion, double restitution, const Eigen::MatrixXd& delassus);

/// Work of the contact forces per period on a motion that is integrated from event to event [J],
///
///     integral of lambda^T x' dt + sum over impulses p of p (x'_- + x'_+) / 2.
///
/// Where a force jumps x' vanishes, so that the sum over the samples has no floor; the speeds beside an
/// impulse are `speeds_beside_impulses`, that of one side through the represented restitution where it has
/// none. Of a penalty law the work of its spring, a total differential, is left out. It says nothing of a
/// force that is not that of the motion: requires motion.integrated.
double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps);

}  // namespace signorini
