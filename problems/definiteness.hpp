#pragma once
// Symmetry and definiteness of structural matrices, up to rounding.

#include "problems/sparse_matrix.hpp"

namespace signorini {

/// max |a_ij|, 0 for a matrix without entries; NaN if some entry is NaN.
double largest_entry(const SparseMatrix& A);

/// |a_ij - a_ji| <= 1e-12 max |a_ij| for all i, j. A is square.
bool is_symmetric(const SparseMatrix& A);

/// x^T A x >= 0 for all x. Judged after scaling to unit diagonal, so that the verdict does not depend on
/// units: curvature down to -1e-10 of the diagonal counts as rounding. A is symmetric and finite. One sparse
/// factorisation at most, none where the diagonal dominates; Sylvester's law of inertia.
bool is_semidefinite(const SparseMatrix& A);

/// x^T A x > 0 for all x != 0, by a margin of 1e-13 of the diagonal. A is symmetric and finite.
bool is_definite(const SparseMatrix& A);

}  // namespace signorini
