#pragma once
// Eigenvalues and vectors of symmetric matrices in extended precision.

#include <optional>
#include <vector>

#include "methods/solvers/extended/matrix.hpp"

namespace signorini::extended {

/// A V = V diag(values) of a symmetric matrix.
struct SymmetricEigenpairs {
  std::vector<long double> values;  ///< n, ascending
  ExtendedMatrix vectors;           ///< V, n x n, orthonormal
};

/// Those of a symmetric n x n matrix, of which the lower triangle is read: they are those of A + dA, and V is
/// orthonormal within rounding, |dA| a small multiple of n epsilon |A|. Householder tridiagonalisation and
/// implicit QR steps, by Eigen, some 9 n^3 operations. None where an entry is not finite, or the steps do not
/// converge, which is not known to happen.
/// Source: [golub2013], section 8.3.
std::optional<SymmetricEigenpairs> symmetric_eigenpairs(const ExtendedMatrix& A);

}  // namespace signorini::extended
