#pragma once
// The exact orbit behind an answer, and its check by another integrator.

#include <memory>

#include "harness/judge/orbit_solver.hpp"

namespace signorini {

/// Polishes an answer to an exact orbit (OrbitFinder), and follows it for one period with CVODE
/// (cvode_return) unless one with its events is confirmed already. Where there is no such orbit, or CVODE
/// does not return to it, the reason.
///
/// Structures that `prefers_reduction` names are polished on what their contacts feel and corrected to the
/// orbit of all coordinates (`polish_reduced_orbit`); what stands in for CVODE is the error bar of
/// `correct_orbit`, which compares with the response of the whole structure. Without a bar, the reason.
/// \param spaces  of large structures; the polisher keeps it
OrbitPolisher exact_orbits(std::shared_ptr<KeptSpace> spaces = std::make_shared<KeptSpace>());

/// The same from a march of the reduced structure from rest (`find_reduced_orbit`).
LargeOrbitFinder reduced_orbits(std::shared_ptr<KeptSpace> spaces = std::make_shared<KeptSpace>());

/// All ways in which the harness finds orbits, with one KeptSpace.
OrbitTools orbit_tools();

}  // namespace signorini
