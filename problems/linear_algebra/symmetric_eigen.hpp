#pragma once
// Eigenvalues of dense symmetric matrices, compiled once, from 32 rows on by LAPACK (docs/decisions/0052).
// Source: [golub2013], ch. 8.

#include <Eigen/Core>

namespace signorini {

/// A x = lambda x.
struct SymmetricEigen {
  bool converged = false;   ///< else nothing below is meant
  Eigen::VectorXd values;   ///< n, rising
  Eigen::MatrixXd vectors;  ///< n x n, of the same order
};

/// Of symmetric A, n x n, of which the lower triangle is looked at; vectors are orthonormal. Not converged
/// where an entry is not finite.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
/// The values alone; all NaN where they do not converge.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

/// A x = lambda B x with x^T B x = 1, B symmetric and positive definite, lower triangles alone. Not converged
/// where B is not definite or an entry is not finite.
SymmetricEigen generalised_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace signorini
