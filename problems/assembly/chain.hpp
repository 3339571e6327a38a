#pragma once
// Masses tied to each other, to a wall and to the ground by springs and dampers.

#include <vector>

#include "problems/structure.hpp"

namespace signorini {

/// A spring and a damper between two masses.
struct Link {
  int first = 0;        ///< one mass
  int second = 0;       ///< another one
  double spring = 0.0;  ///< >= 0 [N/m]
  double damper = 0.0;  ///< >= 0 [N s/m]
};

/// A chain fixed to a wall: element i joins mass i-1 to mass i, element 0 the wall to mass 0. The first three
/// lists have one entry per mass, all entries >= 0; a mass of 0 makes a massless node. Any other topology
/// comes of what may be added to the row, none of it by default: elements between each mass and the ground,
/// and links between any two masses.
struct Chain {
  std::vector<double> masses;               ///< [kg]
  std::vector<double> dampers;              ///< [N s/m]
  std::vector<double> springs;              ///< [N/m]
  std::vector<double> ground_dampers = {};  ///< empty, or one per mass [N s/m]
  std::vector<double> ground_springs = {};  ///< empty, or one per mass [N/m]
  std::vector<Link> links = {};             ///< elements between any two masses
};

/// M = diag(m); a spring k between masses i and j adds k (u_i - u_j)^2 / 2 to the quadratic form of K, one
/// between mass i and the wall or the ground k u_i^2 / 2, and dampers do so to that of D. Nd is the number of
/// masses. \throws std::invalid_argument if the sizes differ
Structure assemble(const Chain& chain);

}  // namespace signorini
