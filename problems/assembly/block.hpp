#pragma once
// An elastic solid: 8-node bricks with trilinear shape functions, three displacements per node.

#include <vector>

#include "problems/assembly/block_mesh.hpp"
#include "problems/assembly/elements.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// An isotropic block of linear elasticity, clamped on its face x = 0. Coordinates are those of the mesh.
/// The bricks are plain trilinear ones: they bend too stiffly where they are long compared to the waves of
/// the motion, and as `poisson` nears 0.5 they lock.
struct Block {
  BlockMesh mesh;                                      ///< its bricks, which give lengths and coordinates
  double young = 1.0;                                  ///< > 0 [N/m^2]
  double poisson = 0.0;                                ///< between -1 and 0.5 [-]
  double density = 1.0;                                ///< > 0 [kg/m^3]
  ContactMass contact_mass = ContactMass::consistent;  ///< how mass is spread over the nodes
  std::vector<int> contacts = {};  ///< coordinates that contacts touch; of use for ContactMass::massless only
};

/// M and K, at most 81 entries in a row, and D = 0, in time and memory proportional to Nd. Element matrices
/// by 2 x 2 x 2 Gauss points, exact for bricks. Lumped: a brick gives an eighth of its mass to each node.
/// Massless: the displacement a contact touches, along an axis say, follows the straight line along that axis
/// through its two nearest nodes without contact there (clamped ones included): all motions linear in x, y
/// and z are kept, and with them the free block's total mass, first and second moments.
/// \throws InvalidProblem (system.contact_mass) if such a line has less than two nodes left
Structure assemble(const Block& block);

/// M before clamping: the nodes at x = 0 come first, numbered like the others.
SparseMatrix unclamped_mass(const Block& block);

/// K before clamping, in the same order.
SparseMatrix unclamped_stiffness(const Block& block);

}  // namespace signorini
