#pragma once
// Least squares and orthogonal bases of dense matrices by Householder reflections, compiled once
// (docs/decisions/0052). Source: [golub2013], ch. 5.

#include <Eigen/Core>
#include <Eigen/QR>

namespace signorini {

/// A P = Q R with columns in the order of what they add, A m x n, neither of them 0.
class PivotedQr {
 public:
  explicit PivotedQr(const Eigen::MatrixXd& A);

  /// Columns that add more than rounding, min(m, n) eps of the largest.
  [[nodiscard]] Eigen::Index rank() const;
  /// The diagonal of R, min(m, n), falling in magnitude.
  [[nodiscard]] Eigen::VectorXd diagonal() const;
  /// The first columns of the orthogonal Q, m x count, count <= m: a basis of A's columns, then of what is
  /// orthogonal to them.
  [[nodiscard]] Eigen::MatrixXd basis(Eigen::Index count) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
};

/// Q of A = Q R without pivoting, A m x n: m x m and orthogonal.
Eigen::MatrixXd householder_basis(const Eigen::MatrixXd& A);

/// Q and R.
struct QrFactors {
  Eigen::MatrixXd Q;  ///< m x m, orthogonal
  Eigen::MatrixXd R;  ///< m x n, upper triangular
};
/// A = Q R without pivoting.
QrFactors householder_qr(const Eigen::MatrixXd& A);

/// The x of least |A x - b|, A m x n of full rank n <= m, by QR without pivoting.
Eigen::VectorXd full_rank_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The x of least |A x - b| by QR with pivoting, where columns that add less than rounding get none.
Eigen::VectorXd pivoted_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The x of least |x| among those of least |A x - b|, by a complete orthogonal decomposition;
/// NaN where A is not finite.
Eigen::VectorXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
/// The same of each column of B.
Eigen::MatrixXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A^+, n x m; NaN where A is not finite.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A);

}  // namespace signorini
