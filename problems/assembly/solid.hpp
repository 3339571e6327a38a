#pragma once
// A solid body of any form, assembled from the elements of its mesh.

#include <memory>
#include <vector>

#include "problems/assembly/elements.hpp"
#include "problems/assembly/solid_mesh.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// An isotropic body of linear elasticity. Coordinates are those of the mesh.
struct Solid {
  std::shared_ptr<const SolidMesh> mesh = std::make_shared<SolidMesh>();  ///< never null
  double young = 1.0;                                                     ///< > 0 [N/m^2]
  double poisson = 0.0;                                                   ///< between -1 and 0.5 [-]
  double density = 1.0;                                                   ///< > 0 [kg/m^3]
  ContactMass contact_mass = ContactMass::consistent;  ///< how mass is spread over the nodes
  std::vector<int> contacts = {};  ///< coordinates that contacts touch; of use for ContactMass::massless only
};

/// M and K of isoparametric elements [zienkiewicz2005], and D = 0; time and memory grow with the number of
/// elements. Lumped: a node has the share of an element's mass that its diagonal entry has of the trace
/// [hinton1976]. Massless: the displacement that a contact touches follows, along its axis, a combination of
/// those of nodes around it that reproduces all motions linear in x, y and z, of least weights: total mass,
/// first and second moments are kept.
/// \throws InvalidProblem (system.mesh) for an element without volume or turned inside out;
/// (system.contact_mass) if no nodes are left about a contact that could carry its mass
Structure assemble(const Solid& solid);

/// M before any node is held, those at rest first.
SparseMatrix unheld_mass(const Solid& solid);

/// K before any node is held, in the same order.
SparseMatrix unheld_stiffness(const Solid& solid);

}  // namespace signorini
