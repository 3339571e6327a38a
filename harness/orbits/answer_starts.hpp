#pragma once
// Searches for orbits from answers: the flow's, every method's, and coarse grids'.

#include <span>
#include <vector>

#include "harness/orbits/orbit_candidate.hpp"
#include "methods/catalogue.hpp"
#include "problems/problem.hpp"

namespace signorini {

// Problems must outlive the units.

/// Marching from rest on the closed-form flow, of any order.
CandidateUnit from_rest(const Problem& problem);

/// Every method of the catalogue that supports the scene and represents its law, from a cold start, with its
/// default options, each step of its ladder and each of its further starts (MethodEntry::starts); settings
/// that come to the same options once. A solve ends after ten seconds.
std::vector<CandidateUnit> cold_starts(const Problem& problem, int order,
                                       std::span<const MethodEntry> catalogue);

/// Hat functions on two coarse grids along waved covering vectors (HatSettings::cover_amplitude), which lead
/// a pivoting method to different solutions. A solve ends after two seconds.
CandidateUnit coarse_grids(const Problem& problem, int order);

}  // namespace signorini
