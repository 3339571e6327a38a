#pragma once
// Factors of sparse symmetric matrices of moderate size, entry by entry, compiled once (docs/decisions/0052).
// Those of large ones: sparse_cholesky.hpp.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace signorini {

/// P A P^T = L L^T, of A n x n the lower triangle, in an order of minimum degree. Copies share their factors.
class SparseLlt {
 public:
  explicit SparseLlt(const Eigen::SparseMatrix<double>& A);

  /// Whether A is finite and positive definite to working precision; solutions mean nothing where it is not.
  [[nodiscard]] bool definite() const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;  ///< A^-1 b
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;  ///< A^-1 B, n x k

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// P A P^T = L D L^T likewise, of A that need not be definite.
class SparseLdlt {
 public:
  explicit SparseLdlt(const Eigen::SparseMatrix<double>& A);

  /// Whether all pivots are finite and none is zero; solutions mean nothing where one is.
  [[nodiscard]] bool regular() const;
  /// The least entry of D.
  [[nodiscard]] double least_pivot() const;
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;  ///< A^-1 B, n x k
  [[nodiscard]] Eigen::SparseMatrix<double> solve(
      const Eigen::SparseMatrix<double>& B) const;  ///< the same of sparse B

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

/// P A Q = L U with partial pivoting, of A that need be neither symmetric nor definite, in an order of little
/// fill [davis2004]. Copies share their factors.
class SparseLu {
 public:
  SparseLu() = default;
  explicit SparseLu(const Eigen::SparseMatrix<double>& A);  ///< A compressed

  /// Whether A was regular; false without one.
  [[nodiscard]] bool regular() const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;  ///< A^-1 b
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;  ///< A^-1 B, n x k

 private:
  struct Factors;
  std::shared_ptr<const Factors> factors_;
};

}  // namespace signorini
