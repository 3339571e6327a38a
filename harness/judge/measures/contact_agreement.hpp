#pragma once
// Whether an answer touches its stops as the orbit near it does.

#include <string>

#include "harness/judge/measures/motion.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// How the contacts of an answer differ from those of an orbit.
struct ContactDifference {
  std::string text = {};     ///< what differs; empty where nothing does
  bool contradicts = false;  ///< one of the two never touches a stop, and the other hits one
};

/// Compares impulses and contact phases, as far as the answer's resolution can show them.
///
/// With J_c the impulse of contact c per forcing period, k_c X T its unit (stiffness scale of the contact,
/// size of the orbit's motion, forcing period): a contact touches if |J_c| > 1e-6 k_c X T, and clearly so if
/// it also is above 1 % of the motion's largest. The two agree if
///
/// - no contact touches clearly in one of them and not at all in the other
/// - no contact is off by more than half of its own motion (`Distance::x_worst`)
/// - the force of no contact that touches clearly on the orbit is off by more than 0.4 of its own
/// - that of none is off by more than 0.06 of the largest and four times the error of x, at most 0.15
///   (`ForceErrors`)
/// - the force is off by at most half in harmonics whose half waves are longer than what counts as one push
///   below or, where the answer's samples of the force show more, than these (`harmonics_of_force`), than
///   1/256 forcing period, and than twice the error of x in forcing periods (`force_error_up_to`)
/// - under Newton's law the strong impacts that the answer lists show a coefficient of restitution within
/// 0.1,
///   as far from them as the orbit's own samples show the law's
/// - a contact that touches clearly pushes throughout in both or in none, breaks that count as one push aside
/// - at every contact, phases whose impulse is at least 25 % of the largest one's in one motion are no more
///   than the phases of at least 5 % in the other, per common period; phases closer than six times the
///   coarser of the two resolutions in time, at most 0.15 forcing periods, count as one, since the coarser
///   motion shows them as one
/// - each of those strong phases has one of the other motion beside it, no farther in time than phases that
///   count as one, or 0.05 forcing periods if that is more
/// - around each phase of at least 6 %, at most 0.15 forcing periods before or after it, phases of at least
///   1 % of the other motion push with half of its impulse, less four times the error of x of the largest
///   impulse of any contact: a force that is small beside another one is told rightly, too.
///
/// They contradict each other if no contact of one touches, and the impulse of the other exceeds 1e-3 k_c X
/// T.
ContactDifference contact_difference(const Problem& problem, const Motion& answer, const Motion& orbit);

}  // namespace signorini
