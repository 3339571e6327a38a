#pragma once
// The branches of exact orbits of a scene, with their own search for beginnings.

#include "methods/curve.hpp"
#include "methods/method.hpp"
#include "methods/orbit/continuation/orbit_branch.hpp"

namespace signorini {

/// Every branch of exact orbits that hangs together (`trace_diagram`) with
///
/// - the contact-free motions and the method's answers at both ends of the interval,
/// - its answers at up to eleven values inside, a tenth of the time at most,
/// - at a rigid stop the orbits of one impact at these values (`one_impact_orbits`),
/// - limits.begin_at.
///
/// All but the first find isolated branches too.
/// \param method  whose answers are exact orbits
/// \throws std::runtime_error where continuation_obstacle names a reason, or `scene.at` throws it
OrbitDiagram exact_diagram(const ParametrisedScene& scene, const Method& method, const CurveLimits& limits);

}  // namespace signorini
