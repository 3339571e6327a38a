#pragma once
// A flexible shaft with a disc, bending in two planes: what a rotor is where its support is not one spring.

#include "problems/assembly/beam.hpp"

namespace signorini {

/// A slender shaft of equal Hermite elements along x, on a bearing at each end, with a disc clamped on one of
/// its nodes. Node n, at x = n length / elements, has four coordinates: 4 n and 4 n + 1 the deflection [m]
/// and the rotation [rad] in one plane, 4 n + 2 and 4 n + 3 those in the plane at right angles to it.
struct Shaft {
  Beam beam;                       ///< mesh, section and material of one beam; nothing of it is clamped
  double disc_mass = 0.0;          ///< >= 0 [kg]
  int disc_node = 0;               ///< 0..elements
  double bearing_stiffness = 1.0;  ///< of each bearing, in any direction, > 0 [N/m]
  double bearing_damping = 0.0;    ///< >= 0 [N s/m]
};

/// M, K, and D of the bearings alone; Nd = 4 (elements + 1). The planes are not coupled: the shaft is seen
/// from rest, its disc is thin, gyroscopic moments are left out.
Structure assemble(const Shaft& shaft);

}  // namespace signorini
