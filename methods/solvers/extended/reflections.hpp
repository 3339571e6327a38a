#pragma once
// Householder reflections and what the eigenvalue iterations share.

#include <vector>

#include "methods/solvers/extended/matrix.hpp"

namespace signorini::extended {

/// Numbers one after another.
using Numbers = std::vector<long double>;

/// Place of a coordinate in Numbers.
inline std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// Whether no entry is infinite or not a number.
bool all_finite(const ExtendedMatrix& A);

/// Whether an entry beside the diagonal is lost in rounding: within epsilon of the sum of the magnitudes of
/// its neighbours on the diagonal or, where these vanish, within epsilon^2 of the norm of the matrix.
bool negligible(long double entry, long double neighbours, long double norm);

/// Overwrites x, `size` numbers, by the u of the reflection I - u u^T that makes it a multiple of the first
/// unit vector, and returns the multiple. u = 0 where x is one. Source: [golub2013], section 5.1.
long double reflect(long double* x, Eigen::Index size);

/// x - (u^T x) u in place, `size` numbers each.
void apply_reflection(const long double* u, long double* x, Eigen::Index size);

/// The product of the n - 2 reflections whose u are the columns of A, n x n, below the diagonal, the first at
/// the left.
ExtendedMatrix product_of_reflections(const ExtendedMatrix& A);

}  // namespace signorini::extended
