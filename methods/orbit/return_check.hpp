#pragma once
// A second path to an exact orbit: one period of the CVODE flow from its state.

#include <functional>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/orbit/exact_trajectory.hpp"

namespace signorini {

/// Where one period of the event-driven flow (CVODE at tolerance 1e-13, events found anew, none of the
/// orbit's sequence used) brings the state at an orbit's section.
struct ReturnCheck {
  bool returned = false;  ///< distance <= allowed
  double distance = 0.0;  ///< max(|du| / X, |dv| / V), in the scales of the motion [-]
  double allowed = 0.0;   ///< the error bar, and CVODE's own error over the period [-]
};

/// CVODE's own error is taken as 3e-11 times the growth of errors over a period. A stiff structure, whose
/// fastest modes it follows through thousands of oscillations, may leave it more: where the orbit is missed
/// by more than that, the error is measured, as four times the distance to a run with ten times the local
/// tolerance, and believed up to 1e-6 times the
/// largest Floquet multiplier, where that is above 1, and up to 1e-3: the orbit itself is as much nearer. By
/// Adams' method; where that does not return, by backward differentiation too: the check is that of the two
/// which comes nearer. By the latter alone where a stiff structure (FlowStructure::stiff) would take Adams'
/// method more than 1e5 steps. `distance` is what the orbit is confirmed to.
///
/// \param dynamics  of the scene that `orbit` was found on
/// \throws FlowError, IntegrationError if the flow fails
ReturnCheck cvode_return(const ContactDynamics& dynamics, const ExactTrajectory& orbit,
                         const std::function<bool()>& expired);

}  // namespace signorini
