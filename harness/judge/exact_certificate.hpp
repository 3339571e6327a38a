#pragma once
// The exact orbit behind an answer, and its check by another integrator.

#include "harness/judge/orbit_solver.hpp"

namespace signorini {

/// Polishes an answer to an exact orbit (OrbitFinder), and follows it for one period with CVODE
/// (cvode_return) unless one with its events is confirmed already. Where there is no such orbit, or CVODE
/// does not return to it, the reason.
OrbitPolisher exact_orbits();

/// Both ways in which the harness finds orbits.
OrbitTools orbit_tools();

}  // namespace signorini
