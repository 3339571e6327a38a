#pragma once
// Slender structures. A bar in tension and compression: 2-node finite elements with linear shape functions; a
// beam in bending (Euler-Bernoulli): 2-node finite elements with Hermite's cubic shape functions;
// and a flexible shaft, such a beam in two planes: what a rotor is where its support is not one spring.

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

/// A straight beam of equal elements, clamped at x = 0. Node i + 1, at x = (i + 1) length / elements, has two
/// coordinates: 2 i its deflection w [m], 2 i + 1 its rotation dw/dx [rad]. There may be several such beams,
/// side by side, that nothing but contacts joins: the coordinates of beam b start at 2 elements b.
struct Beam {
  int elements = 1;                                    ///< of each beam, >= 1; Nd = 2 elements count
  int count = 1;                                       ///< of equal beams, >= 1
  double length = 1.0;                                 ///< > 0 [m]
  double area = 1.0;                                   ///< of the cross-section, > 0 [m^2]
  double inertia = 1.0;                                ///< second moment of area, > 0 [m^4]
  double young = 1.0;                                  ///< > 0 [N/m^2]
  double density = 1.0;                                ///< > 0 [kg/m^3]
  ContactMass contact_mass = ContactMass::consistent;  ///< how mass is spread over the nodes
  std::vector<int> contacts = {};  ///< coordinates that contacts touch; of use for ContactMass::massless only
};

/// M and K, and D = 0. Rotary inertia of the cross-section is left out. Lumped: element mass m = density area
/// h to equal halves on its deflections, m h^2 / 78 on each rotation [hinton1976]. Massless: the deflection
/// of a contact node follows the rotations (trapezoidal rule) from the nearest nodes without contact on
/// either side, the mean of both weighted by nearness; total mass, first and second moments of the free beam
/// are kept. \throws InvalidProblem (system.contact_mass) if a contact touches a rotation and is to be
/// massless
Structure assemble(const Beam& beam);

/// M of a single beam before clamping, 2 (elements + 1) square: coordinates 2 i and 2 i + 1 are
/// those of node i. `contacts` are counted as if the beam were clamped.
SparseMatrix unclamped_mass(const Beam& beam);

/// K of a single beam before clamping, 2 (elements + 1) square.
SparseMatrix unclamped_stiffness(const Beam& beam);

/// A slender shaft of equal Hermite elements along x, on a bearing at each end, with a disc clamped on one of
/// its nodes. Node n, at x = n length / elements, has four coordinates: 4 n and 4 n + 1 the deflection [m]
/// and the rotation [rad] in one plane, 4 n + 2 and 4 n + 3 those in the plane at right angles to it.
struct Shaft {
  Beam beam;                       ///< mesh, section and material of one beam; nothing of it is clamped
  double disc_mass = 0.0;          ///< >= 0 [kg]
  int disc_node = 0;               ///< 0..elements
  double bearing_stiffness = 1.0;  ///< of each bearing, in any direction, > 0 [N/m]
  double bearing_damping = 0.0;    ///< >= 0 [N s/m]
  double disc_inertia = 0.0;       ///< about a diameter, >= 0 [kg m^2]
  double polar_inertia = 0.0;      ///< about the axis, 0..2 disc_inertia [kg m^2]
  double spin = 0.0;               ///< Omega, angular velocity from the first plane to the second [rad/s]
};

/// M, K, and D of the bearings and of the disc's gyroscopic moment; Nd = 4 (elements + 1). The shaft is seen
/// from rest. With the rotations theta = dv/dx and phi = dw/dx of the disc in the two planes, its angular
/// momentum polar_inertia Omega about the axis adds polar_inertia Omega phi' to the moment balance of theta
/// and -polar_inertia Omega theta' to that of phi [genta2005, ch. 4]: skew, of no work. It stiffens forward
/// whirl and softens backward whirl; without it the planes are not coupled. That of the shaft itself is left
/// out.
Structure assemble(const Shaft& shaft);

/// The skew part of that D, of the disc's gyroscopic moment, Nd x Nd [N s/m].
SparseMatrix gyroscopic_matrix(const Shaft& shaft);

}  // namespace signorini
