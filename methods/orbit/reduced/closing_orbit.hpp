#pragma once
// Orbits of the contacts that close, the others looked at.

#include <memory>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

/// The contacts that push in a motion as far as it shows, ascending: those of its events and impulses, and
/// those with a force at one of its nodes or of 4096 instants.
std::vector<int> pushing_contacts(const Trajectory& motion);

/// `OrbitFinder::find` from a motion, on those contacts of a structure that close: the others have no part in
/// the equations (`with_open_contacts`), and are looked at in the orbit found. Those that pass their stops
/// join, and the search goes on from that orbit. Where these contacts alone have no orbit all are taken, of
/// up to 150. Machine parts may have a thousand contacts of which ten close in a motion.
///
/// \param structure  with all contacts of the scene
/// \param closing    ascending; those that join are added
/// \param motion     of all contacts of the scene
/// \param shared     modes known from other scenes, if any
/// \return of all joins together; failures are outcomes of the orbit
/// \throws std::runtime_error if the structure cannot be followed (`FlowStructure`)
OrbitSearch find_closing_orbit(const Problem& problem, const CondensedStructure& structure,
                               std::vector<int>& closing, const Trajectory& motion,
                               const SearchOptions& options, const std::shared_ptr<SharedModes>& shared = {});

}  // namespace signorini
