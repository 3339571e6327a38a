#pragma once
// Where the search for all orbits of a scene starts from.

#include <span>
#include <vector>

#include "harness/orbits/orbit_candidate.hpp"
#include "methods/catalogue.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Starts at period `order` forcing periods, in a fixed order:
///
/// 1. at order 1: marching from rest on the closed-form flow
/// 2. every method that applies, from cold starts with its defaults, its ladder and its further starts
/// 3. hat functions on coarse grids along other covering vectors
/// 4. `starts` random states, the same ones first whatever `starts` is
///
/// \param problem  must outlive the units
std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue = method_catalogue());

}  // namespace signorini
