#pragma once
// Eigenvalues of general real matrices in extended precision, with right and left vectors.

#include <optional>
#include <vector>

#include "methods/solvers/extended/matrix.hpp"

namespace signorini::extended {

/// The real form of A X = X diag(mu). Entry k of the values belongs to column k of the vectors. A real value
/// has imaginary[k] = 0 and X_k as its vector; a pair r +- i s, s > 0, holds two places,
///
///     real = (r, r),   imaginary = (s, -s),   A (X_k +- i X_k+1) = (r +- i s) (X_k +- i X_k+1),
///
/// so that conjugates are so exactly. Each complex vector, X_k or X_k + i X_k+1, has norm 1. The left vector
/// w, w A = mu w, w v = 1, is row k of X^-1, or (row k - i row k+1) / 2.
struct Eigenbasis {
  std::vector<long double> real;       ///< n
  std::vector<long double> imaginary;  ///< n
  ExtendedMatrix vectors;              ///< X, n x n
  ExtendedMatrix inverse;              ///< X^-1
};

/// That of a real n x n matrix: values and vectors are those of A + dA, |dA| a small multiple of n epsilon
/// |A|, each vector with a dA of its own. Householder reduction to Hessenberg form, Francis' steps with two
/// shifts and back substitution, by Eigen, some 30 n^3 operations. None where an entry is not finite, the
/// steps do not converge, or vectors depend on each other exactly; a defective matrix mostly has vectors that
/// do so nearly, and an inverse of 1 / epsilon: |X_k| |X^-1 row k| is the condition of a value. Source:
/// [golub2013], sections 7.4 to 7.6.
std::optional<Eigenbasis> eigenbasis(const ExtendedMatrix& A);

}  // namespace signorini::extended
