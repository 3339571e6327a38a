#pragma once
// A periodic motion by following the flow: from a start to the steady state, and the trajectory of its
// period.

#include "methods/flow/flow.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/method.hpp"

namespace signorini {

/// How a periodic motion is reached by the flow.
struct PeriodicMotionOptions {
  double tolerance = 1e-9;                    ///< of the flow; periodic within ten of it [-]
  bool shooting = false;                      ///< Newton's method on the stroboscopic map; else marching
  Integrator integrator = Integrator::cvode;  ///< of the motion between events
  int max_iterations = 5000;                  ///< periods marched, or Newton steps of the shooting [-]
  int max_order = 8;                          ///< highest period order that marching detects [-]
};

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
