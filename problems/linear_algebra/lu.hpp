#pragma once
// LU factors of dense matrices and solves with them, compiled once (docs/decisions/0052).
//
// All functions take finite matrices; of others the result is not finite. Nothing throws but std::bad_alloc.

#include <Eigen/Core>
#include <Eigen/LU>

namespace signorini {

/// P A = L U with partial pivoting, A n x n and real. Source: [golub2013], ch. 3.4.
class LuFactors {
 public:
  LuFactors() = default;
  explicit LuFactors(const Eigen::MatrixXd& A);
  /// The factors of another matrix in place of these; memory of one size is used again.
  void compute(const Eigen::MatrixXd& A);

  /// A^-1 b; not finite where A is singular.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// A^-1 B, n x k.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;
  [[nodiscard]] Eigen::MatrixXd inverse() const;
  /// An estimate of 1 / (|A|_1 |A^-1|_1), mostly within a factor of three [-]; of a singular matrix rounding,
  /// 0 or NaN.
  [[nodiscard]] double reciprocal_condition() const;
  [[nodiscard]] double determinant() const;
  /// The diagonal of U, n.
  [[nodiscard]] Eigen::VectorXd pivots() const;
  /// det P, 1 or -1: det A is its product with the pivots.
  [[nodiscard]] double permutation_sign() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

/// Factors of a real matrix that lie in the caller's array, which they replace.
class LuFactorsInPlace {
 public:
  /// \param A  n x n; overwritten by its factors, to be kept by the caller
  explicit LuFactorsInPlace(Eigen::MatrixXd& A);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;  ///< A^-1 b
  [[nodiscard]] double reciprocal_condition() const;  ///< as LuFactors::reciprocal_condition

 private:
  Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu_;
};

/// P A Q = L U with complete pivoting, A n x n and real: slower, and it tells the rank.
/// Source: [golub2013], ch. 3.4.
class CompleteLuFactors {
 public:
  CompleteLuFactors() = default;
  explicit CompleteLuFactors(const Eigen::MatrixXd& A);

  /// A^-1 b; where A is singular, a solution of the equations that have one.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Whether all pivots are above rounding, n eps of the largest.
  [[nodiscard]] bool regular() const;
  /// As LuFactors::reciprocal_condition; of a singular matrix only of the part that can be inverted.
  [[nodiscard]] double reciprocal_condition() const;
  /// The least magnitude on the diagonal of U.
  [[nodiscard]] double least_pivot() const;

 private:
  Eigen::FullPivLU<Eigen::MatrixXd> lu_;
};

/// A^-1 b by partial pivoting, for one right-hand side; not finite where A is singular.
Eigen::VectorXd lu_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
/// A^-1 B, n x k.
Eigen::MatrixXd lu_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// det A, n x n; 1 for n = 0.
double determinant(const Eigen::MatrixXd& A);

/// L^-1 B for the lower triangle of L, n x n, and B n x k.
Eigen::MatrixXd lower_solve(const Eigen::MatrixXd& L, const Eigen::MatrixXd& B);

}  // namespace signorini
