#pragma once
// The orbits of a branch at one value of the parameter.

#include <vector>

#include "methods/orbit/continuation/branch.hpp"
#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// The points where a branch takes a value of the parameter: between each two neighbours on either side of
/// it, corrected there. Two that nearly meet, at a fold, may come out as one.
std::vector<SequencedOrbit> orbits_at(OrbitFamily& family, const Branch& branch, double parameter);

}  // namespace signorini
