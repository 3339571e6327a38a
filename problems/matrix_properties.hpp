#pragma once
// Properties of structural matrices, up to rounding: symmetry, definiteness, proportional damping.

#include <optional>

#include "problems/structure.hpp"

namespace signorini {

/// Of the largest entry of a matrix: what counts as rounding of it [-].
inline constexpr double kEntryRounding = 1e-12;

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

/// alpha M + beta K. Memory for the sum alone is taken: sums of sparse matrices as Eigen evaluates them grow
/// by doubling, and of a large block each is a gigabyte.
SparseMatrix combination(const ProportionalDamping& factors, const SparseMatrix& M, const SparseMatrix& K);

/// alpha, beta with |D - alpha M - beta K| <= 1e-12 max |d_ij|; nothing for any other D or an unsymmetric K.
std::optional<ProportionalDamping> proportional_damping(const SparseMatrix& M, const SparseMatrix& K,
                                                        const SparseMatrix& D);
/// Those that D was assembled by, else as fitted to the matrices. A share of D below 1e-13 of its largest
/// entry is none.
std::optional<ProportionalDamping> proportional_damping(const Structure& structure);

}  // namespace signorini
