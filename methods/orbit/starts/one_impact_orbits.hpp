#pragma once
// Periodic orbits with a single impact, from their closed form: starts of branches that hang together with
// no other.

#include <vector>

#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// Orbits of a rigid scene that strike one stop once in n periods of the load. With x_f the contact-free
/// motion of contact j, which returns after one period, and g_0, g_-, g_+ displacement and velocities, before
/// and after, at periodic unit impulses, an impact at phase theta takes the impulse and leaves the velocity
///
///     p = (g_j - x_f(theta)) / g_0,     (1 + e) x_f'(theta) + p (g_+ + e g_-) = 0.
///
/// All theta are found whose roots 256 samples of a period of the load separate. Without a periodic load one
/// of them, for the others are the same orbit at another time. Admissible or not.
///
/// Where the contact-free motion is not unique, as of parts that no spring holds, state and impulse solve
/// y = Phi(n T) y + d(theta) + (0, M^-1 w) p with w^T u = g_j in their place.
///
/// \return none where neither has one solution, and for compliant or massless contacts
std::vector<SequencedOrbit> one_impact_orbits(OrbitFamily& family, double parameter, int contact, int order);

}  // namespace signorini
