#pragma once
// A periodic motion by following the flow: from a start to the steady state, by marching until it repeats or
// by shooting, and the trajectory of its period.

#include <functional>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/method.hpp"
#include "methods/periodic_motion/period_map.hpp"

namespace signorini {

/// How a periodic motion is reached by the flow.
struct PeriodicMotionOptions {
  double tolerance = 1e-9;                    ///< of the flow; periodic within ten of it [-]
  bool shooting = false;                      ///< Newton's method on the stroboscopic map; else marching
  Integrator integrator = Integrator::cvode;  ///< of the motion between events
  int max_iterations = 5000;                  ///< periods marched, or Newton steps of the shooting [-]
  int max_order = 8;                          ///< highest period order that marching detects [-]
  double begin = 0.0;                         ///< instant of a guess that is no flow's, to start from [s]

  /// Residual that counts as periodic: ten tolerances, but not below the noise left by the integration [-].
  [[nodiscard]] double accepted() const;
};

/// Follows the motion from `start` until it repeats every `order` <= max_order forcing periods.
///
/// A fixed point of the stroboscopic map is proposed by Newton's method from the present state and taken
/// only if marching goes there: (1) its residual is at most ten tolerances; (2) all its multipliers are
/// inside the unit circle; (3) the distance of the last states marched to it shrinks at every turn, in the
/// norm of the multipliers' eigenvectors, and these turns are linear or, within the turns that the
/// slowest multiplier takes to a tenth, 32 at most, become so or bring it nearer by the root of what that
/// multiplier makes of a distance in them, so that the contraction has set in; (4) marched on from an orbit
/// of order p > 1 for 3 p periods, the motion repeats itself within ten tolerances, and no smaller order
/// does. So a slowly converging transient, a near miss of a chaotic motion or a noise-level cycle is not
/// taken for a period. Where Newton's method fails (grazing, monodromy too large) the motion must repeat
/// within ten tolerances for several turns and the geometric rest of its convergence be below a hundred.
/// \throws FlowError, IntegrationError
FixedPoint march(PeriodMap& map, const FlowState& start, const PeriodicMotionOptions& options,
                 const std::function<bool()>& expired);

/// Newton's method on P^order from `start`; finds unstable motions too.
/// \throws FlowError, IntegrationError
FixedPoint shoot(PeriodMap& map, const FlowState& start, int order, const PeriodicMotionOptions& options,
                 const std::function<bool()>& expired);

/// Marches `state` to the phase of the forcing that is furthest from the given events, so that none of
/// them can cross the instant where the motion is cut open.
/// \throws FlowError, IntegrationError
void move_to_quiet_phase(PeriodMap& map, FlowState& state, const std::vector<ContactEvent>& events);

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
