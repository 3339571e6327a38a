#pragma once
// What a structural matrix must be: symmetric and positive semi-definite, up to rounding.

#include "problems/problem.hpp"

namespace signorini {

/// Whether M, K and the symmetric part of D have to be factorised to know that they are what they must be.
/// Sums of finite-element matrices are, whatever the mesh: M and K are semi-definite, and a motion without
/// strain energy carries mass. A factorisation of theirs would cost more than all else about a large scene.
enum class Definiteness { to_be_checked, by_construction };

/// validate(), which checks all, or all but what holds by construction: that M and K are semi-definite and
/// have no null vector in common with D. Damping still must be alpha M + beta K with alpha, beta >= 0, or
/// pass the check. \throws InvalidProblem on the first violation
void validate(const Problem& problem, Definiteness definiteness);

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
