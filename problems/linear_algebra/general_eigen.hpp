#pragma once
// Eigenvalues of dense real matrices that need not be symmetric, compiled once (docs/decisions/0052).
// Source: [golub2013], ch. 7.

#include <Eigen/Core>

namespace signorini {

/// A x = mu x.
struct GeneralEigen {
  bool converged = false;    ///< else nothing below is meant
  Eigen::VectorXcd values;   ///< n; of a conjugate pair the one above the real axis first
  Eigen::MatrixXcd vectors;  ///< n x n, each of Euclidean length 1
};

/// Of real A, n x n. Not converged where an entry is not finite.
GeneralEigen general_eigen(const Eigen::MatrixXd& A);
/// The values alone; all NaN where they do not converge.
Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A);
/// Those of largest magnitude, falling, of a conjugate pair both: up to the first whose residual |A x - mu
/// x|, |x| = 1, is more than tolerance max(1, |mu|_max); none where an entry is not finite. On the Krylov
/// space of A from four columns of A^24, 32 in all, 56 where fewer than four would be known: where magnitudes
/// fall slowly few are known, and of a multiplicity beyond four not all. Some 1e2 products of A with a
/// vector. Source: [golub2013], ch. 10.5.
Eigen::VectorXcd leading_eigenvalues(const Eigen::MatrixXd& A, double tolerance);
/// The largest magnitude of eigenvalues, 0 where there are none: the spectral radius; of Floquet multipliers
/// what small disturbances grow by in a period.
double largest_magnitude(const Eigen::VectorXcd& values);

}  // namespace signorini
