#pragma once
// A periodic motion by following the flow: from a start to the steady state, and the trajectory of its
// period.

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/method.hpp"
#include "methods/periodic_motion/steady_state.hpp"

namespace signorini {

/// Follows the flow of `dynamics` from rest or from a guess until it is periodic: by marching (`march`, of
/// any order up to max_order, but at least the problem's subharmonic) or by shooting (`shoot`, of period
/// Problem::period(); without a guess from a motion that has forgotten its start from rest). Verdict,
/// message, counts and residual are those of the search; the trajectory is an `EventTrajectory` of one
/// period, that of the last state where the search failed. Failures of the flow and the deadline are
/// messages, not exceptions.
///
/// \param dynamics  of `problem`
Solution find_periodic_motion(const Problem& problem, const ContactDynamics& dynamics,
                              const PeriodicMotionOptions& options, const Start& start);

}  // namespace signorini
