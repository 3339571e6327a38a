#pragma once
// The orbits of a branch: of its points, and at one value of the parameter.

#include <cstddef>
#include <vector>

#include "methods/orbit/continuation/orbit_branch.hpp"
#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// The orbit of the i-th point of a branch.
SequencedOrbit orbit_of(const OrbitFamily& family, const OrbitBranch& branch, std::size_t i);

/// The points where a branch takes a value of the parameter: between each two neighbours on either side of
/// it, corrected there. Two that nearly meet, at a fold, may come out as one.
std::vector<SequencedOrbit> orbits_at(OrbitFamily& family, const OrbitBranch& branch, double parameter);

}  // namespace signorini
