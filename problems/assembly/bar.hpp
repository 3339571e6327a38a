#pragma once
// An elastic bar in tension and compression: 2-node finite elements with linear shape functions.

#include <vector>

#include "problems/assembly/elements.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// A straight bar of equal elements, clamped at x = 0. Coordinate i is the displacement along x of node i +
/// 1, at x = (i + 1) length / elements; the last one is the free end.
struct Bar {
  int elements = 1;                                    ///< >= 1; Nd = elements
  double length = 1.0;                                 ///< > 0 [m]
  double area = 1.0;                                   ///< > 0 [m^2]
  double young = 1.0;                                  ///< > 0 [N/m^2]
  double density = 1.0;                                ///< > 0 [kg/m^3]
  ContactMass contact_mass = ContactMass::consistent;  ///< how mass is spread over the nodes
  std::vector<int> contacts = {};  ///< coordinates that contacts touch; of use for ContactMass::massless only
};

/// M and K, both tridiagonal, and D = 0. A massless node follows the straight line through its two nearest
/// nodes without contact (the clamped one included): total mass, first and second moments of the free bar are
/// kept. \throws InvalidProblem (system.contact_mass) if too few nodes are left to carry the mass
Structure assemble(const Bar& bar);

/// M before clamping, elements + 1 square: coordinate i is node i.
SparseMatrix unclamped_mass(const Bar& bar);

}  // namespace signorini
