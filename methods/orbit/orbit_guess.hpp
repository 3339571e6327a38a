#pragma once
// From any motion to a sequence of events that an exact orbit may run through.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "methods/orbit/orbit_equations.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// Events per period that an orbit is polished with: its equations are dense in them [-]
inline constexpr std::size_t kMostEvents = 400;

/// The state at a quiet instant of the period and the sequence of events, made from what any trajectory
/// tells. Where it lists its events, kMostEvents of them at most, they are the sequence (`listed_sequence`).
/// Else both are read off the contact force:
///
/// the forces f(t_k) of N samples (its own nodes, 8 per harmonic, or 4096) act as impulses f(t_k) T / N, next
/// to the impulses listed, on the structure, whose periodic response is summed in closed form: y_0 = (I -
/// Phi(T))^-1 (response from rest + sum_k Phi(t_0 + T - t_k) (0, M^-1 W p_k)). A phase of contact
/// (`contact_phases`) is an impact at its centroid if it is no longer than the motion can resolve, else lasts
/// from its first to its last sample.
///
/// The motion is one of all contacts of the scene, of which those are read that act in the model.
///
/// The section lies in the middle of the longest time without a force, or of the longest between two events.
/// Where motions of the structure return by themselves, as of parts that no spring holds, the response is the
/// one next to the motion's displacements. Empty if the motion is not of the model's period.
/// \throws std::runtime_error if a flow cannot be formed, or the time is up
std::optional<OrbitGuess> orbit_guess(OrbitModel& model, const Trajectory& motion,
                                      const Expired& expired = {});

/// One period of a motion from its own list of events, cut open at `section`:
///
/// - events of one instant (1e-12 of the period) become one entry of the sequence, whose guard is that of a
///   contact that closes or strikes, or, where none does, of one that opens; impacts that do not feel each
///   other through the mass (`impact_groups`) become one entry each;
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
/// \throws std::runtime_error if a flow cannot be formed, or the time is up
std::optional<OrbitGuess> listed_sequence(OrbitModel& model, std::vector<ContactEvent> events, double section,
                                          const std::vector<bool>& pushing, const Expired& expired = {});

/// The events met in one period from the state of `guess` by the modal event-driven flow (tolerance 1e-12),
/// the section moved to the middle of the longest time between two of them. Empty where the flow fails or the
/// same contacts are not closed after a period. `end`, if given, receives the state one period on.
std::optional<OrbitGuess> simulated_sequence(OrbitModel& model, const FlowState& start,
                                             const std::function<bool()>& expired, FlowState* end = nullptr);

}  // namespace signorini
