#pragma once
// A disc that moves in its plane, and the stator around it: a polygon of contacts.

#include "problems/problem.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// A disc on an isotropic elastic support (Jeffcott's rotor seen at rest): coordinates 0 and 1 are the
/// displacements of its centre along two axes at right angles [m].
struct Rotor {
  double mass = 1.0;       ///< > 0 [kg]
  double damping = 0.0;    ///< >= 0 [N s/m]
  double stiffness = 1.0;  ///< >= 0 [N/m]
};

/// The three 2 x 2 matrices, multiples of the identity.
Structure assemble(const Rotor& rotor);

/// Contacts of a round hole approximated by a regular polygon: contact j, of `facets` >= 3, limits the
/// displacement in direction 2 pi j / facets, x_j = cos u[first] + sin u[second] <= gap. The polygon touches
/// the circle of radius gap from outside; its corners are at gap / cos(pi / facets).
std::vector<Contact> ring_of_contacts(int first, int second, int facets, double gap);

}  // namespace signorini
