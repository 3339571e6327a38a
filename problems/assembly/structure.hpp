#pragma once
// What every kind of scene is assembled into.

#include "problems/problem.hpp"

namespace signorini {

/// M [kg], D [N s/m] and K [N/m] of one structure, all Nd x Nd.
struct Structure {
  SparseMatrix mass;
  SparseMatrix damping;
  SparseMatrix stiffness;
};

}  // namespace signorini
