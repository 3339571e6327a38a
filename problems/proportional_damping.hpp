#pragma once
// Damping that is a combination of mass and stiffness, found again from the matrices.

#include <optional>

#include "problems/sparse_matrix.hpp"

namespace signorini {

/// D = alpha M + beta K.
struct ProportionalDamping {
  double alpha = 0.0;  ///< [1/s]
  double beta = 0.0;   ///< [s]
};

/// alpha and beta with |D - alpha M - beta K| <= 1e-12 max |d_ij|, entry by entry; nothing for any other D.
std::optional<ProportionalDamping> proportional_damping(const SparseMatrix& M, const SparseMatrix& K,
                                                        const SparseMatrix& D);

}  // namespace signorini
