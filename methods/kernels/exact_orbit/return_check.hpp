#pragma once
// A second path to an exact orbit: one period of the CVODE flow from its state.

#include <functional>

#include "methods/kernels/event_flow/contact_dynamics.hpp"
#include "methods/kernels/exact_orbit/exact_trajectory.hpp"

namespace signorini {

/// Where one period of the event-driven flow (CVODE at tolerance 1e-13, events found anew, none of the
/// orbit's sequence used) brings the state at an orbit's section.
struct ReturnCheck {
  bool returned = false;  ///< distance <= allowed
  double distance = 0.0;  ///< max(|du| / X, |dv| / V), in the scales of the motion [-]
  double allowed = 0.0;   ///< the error bar, and CVODE's floor times the growth of errors over a period [-]
};

/// \param dynamics  of the scene that `orbit` was found on
/// \throws FlowError, IntegrationError if the flow fails
ReturnCheck cvode_return(const ContactDynamics& dynamics, const ExactTrajectory& orbit,
                         const std::function<bool()>& expired);

}  // namespace signorini
