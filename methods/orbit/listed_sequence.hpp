#pragma once
// The sequence of an orbit from the events that a motion lists itself.

#include <optional>
#include <vector>

#include "methods/orbit/orbit_equations.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// One period of a motion from its own list of events, cut open at `section`:
///
/// - events of one instant (1e-12 of the period) become one entry of the sequence, whose guard is that of a
///   contact that closes or strikes, or, where none does, of one that opens;
/// - a contact takes an impulse where one is listed, with the scene's restitution if it was open before and
///   is so afterwards, else with 0; a rigid contact that closes or strikes without one takes what it needs;
/// - a rigid contact that closes without an impulse after an impact ends a chatter: it sticks from that
///   impact on.
///
/// For given instants the equations of an orbit are linear in the state at the section (OrbitEquations):
/// the state is their solution in the least squares, so that neither the force nor a periodic response of
/// the structure is needed.
///
/// \param events   one period, times in [0, period)
/// \param section  [s], no event's instant
/// \param pushing  Nc, contacts that push throughout where they list neither a closing nor an opening
/// \return empty where the list contradicts itself (a contact opens twice, ...) or no state is found
/// \throws std::runtime_error if a flow cannot be formed
std::optional<OrbitGuess> listed_sequence(OrbitModel& model, std::vector<ContactEvent> events, double section,
                                          const std::vector<bool>& pushing);

}  // namespace signorini
