#pragma once
// Cholesky factors of dense symmetric matrices, compiled once (docs/decisions/0052).

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace signorini {

/// A = L L^T for symmetric A, n x n, of which the lower triangle is looked at. Source: [golub2013], ch. 4.2.
class CholeskyFactors {
 public:
  explicit CholeskyFactors(const Eigen::MatrixXd& A);

  /// Whether A is finite and positive definite to working precision; all else means nothing where it is not.
  [[nodiscard]] bool definite() const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;  ///< A^-1 b
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;  ///< A^-1 B, n x k
  [[nodiscard]] Eigen::MatrixXd inverse() const;                        ///< A^-1
  /// An estimate of 1 / (|A|_1 |A^-1|_1), mostly within a factor of three [-].
  [[nodiscard]] double reciprocal_condition() const;
  /// L^T B, n x k.
  [[nodiscard]] Eigen::MatrixXd upper_times(const Eigen::MatrixXd& B) const;
  /// B <- B L^-T, k x n: columns with the Gram matrix A become orthonormal.
  void normalise_columns(Eigen::MatrixXd& B) const;

 private:
  Eigen::LLT<Eigen::MatrixXd> factors_;
};

/// A^-1 b for symmetric A that may be semi-definite, by L D L^T with pivoting.
Eigen::VectorXd ldlt_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace signorini
