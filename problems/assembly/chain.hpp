#pragma once
// Masses in a row, each tied to the one before by a spring and a damper.

#include <vector>

#include "problems/assembly/structure.hpp"

namespace signorini {

/// A chain fixed to a wall: element i joins mass i-1 to mass i, element 0 the wall to mass 0.
/// All three have one entry per mass, all entries >= 0; a mass of 0 makes a massless node.
struct Chain {
  std::vector<double> masses;   ///< [kg]
  std::vector<double> dampers;  ///< [N s/m]
  std::vector<double> springs;  ///< [N/m]
};

/// M = diag(m), K and D tridiagonal: element i adds a_i (u_i - u_{i-1})^2 / 2 to its quadratic form.
/// Nd is the number of masses. \throws std::invalid_argument if the sizes differ
Structure assemble(const Chain& chain);

}  // namespace signorini
