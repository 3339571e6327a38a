#pragma once
// Matrices that are not symmetric: gyroscopic forces in D, circulatory ones in K.

#include "problems/structure.hpp"

namespace signorini {

/// (A + A^T) / 2: of D what dissipates, of K what stores energy. A is square.
inline SparseMatrix symmetric_part(const SparseMatrix& A) { return 0.5 * (A + SparseMatrix(A.transpose())); }

}  // namespace signorini
