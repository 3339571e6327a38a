#pragma once
// Dense matrices in extended precision, by plain loops that are compiled once.

#include <Eigen/Core>
#include <optional>

namespace signorini {

/// 64 bits of mantissa on x86. Storage alone: an expression of it instantiates Eigen anew for long double,
/// and each kind of expression costs a compilation as much as a small source does. Its exponents reach from
/// 1e-4932 to 1e4932: squares of what fits into a double need no scaling.
using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

namespace extended {

/// A in extended precision, exactly.
ExtendedMatrix widened(const Eigen::MatrixXd& A);

/// A in double, each entry rounded to the nearest.
Eigen::MatrixXd rounded(const ExtendedMatrix& A);

/// Whether no entry is infinite or not a number.
bool all_finite(const ExtendedMatrix& A);

/// n x n.
ExtendedMatrix identity(Eigen::Index n);

/// A^T.
ExtendedMatrix transposed(const ExtendedMatrix& A);

/// sqrt(sum A_ij^2).
long double norm(const ExtendedMatrix& A);

/// A B, A m x k and B k x n: each entry within k epsilon of that of |A| |B|.
ExtendedMatrix product(const ExtendedMatrix& A, const ExtendedMatrix& B);

/// A^T B, A k x m and B k x n, likewise.
ExtendedMatrix transposed_product(const ExtendedMatrix& A, const ExtendedMatrix& B);

/// A = L L^T.
struct Cholesky {
  bool definite = false;  ///< A is: all pivots are positive
  /// n x n, lower triangular. Where A is not definite, columns from the first pivot on that is not positive
  /// are those of A.
  ExtendedMatrix L;
};

/// The factor of a symmetric n x n matrix, of which the lower triangle is read: A + dA = L L^T exactly,
/// |dA_ij| within (n + 1) epsilon of |L| |L^T|. Source: [golub2013], section 4.2.
Cholesky cholesky(const ExtendedMatrix& A);

/// L^-1 B by forward substitution, L n x n, of which the lower triangle is read, and B n x m; not finite
/// where a diagonal entry is zero. Source: [golub2013], section 3.1.
ExtendedMatrix solve_lower(const ExtendedMatrix& L, const ExtendedMatrix& B);

/// A^-1 of a square matrix by factors P A = L U with row pivots, P a permutation: of backward errors of n
/// epsilon times the growth of the pivots. None where a pivot is zero or not a number.
/// Source: [golub2013], section 3.4.
std::optional<ExtendedMatrix> inverse(const ExtendedMatrix& A);

}  // namespace extended
}  // namespace signorini
