#pragma once
// Searches for orbits from random states.

#include "harness/orbits/orbit_candidate.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Random states `first` to `last` - 1 at period `order` forcing periods, one search each: displacements and
/// velocities uniform within a magnitude that is log-uniform in 0.1 to 10 scales of the motion, at a random
/// phase of the forcing, followed for 0 to 20 periods before the search takes over. Each has a generator of
/// its own, seeded with (seed, order, number): a state does not depend on which others are drawn. A search
/// ends after two seconds.
///
/// \param problem  must outlive the unit
CandidateUnit random_states(const Problem& problem, int order, int first, int last, unsigned seed);

}  // namespace signorini
