#pragma once
// Singular values and vectors of dense matrices, compiled once (docs/decisions/0052): by Jacobi's rotations
// up to 31 rows and columns, above by LAPACK. Source: [golub2013], ch. 8.6.

#include <Eigen/Core>

namespace signorini {

/// A = U diag(s) V^T, A m x n.
struct SingularValues {
  Eigen::VectorXd values;  ///< s, min(m, n), falling; not a number where A is not finite or LAPACK did not
                           ///< converge
  Eigen::MatrixXd U;       ///< m x m, or m x min(m, n) of `left_singular_vectors`
  Eigen::MatrixXd V;       ///< n x n; empty where they were not asked for
};

/// With all vectors of both sides.
SingularValues singular_vectors(const Eigen::MatrixXd& A);
/// U, m x min(m, n), and s alone.
SingularValues left_singular_vectors(const Eigen::MatrixXd& A);
/// V, n x n, alone: its last n - rank columns span the null space of A.
Eigen::MatrixXd right_singular_vectors(const Eigen::MatrixXd& A);
/// The least singular value of A; infinite for a matrix without rows or columns.
double least_singular_value(const Eigen::MatrixXd& A);

}  // namespace signorini
