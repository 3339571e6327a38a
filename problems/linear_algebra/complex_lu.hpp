#pragma once
// LU factors of dense complex matrices and solves with them, compiled once (docs/decisions/0052), as lu.hpp
// has them of real ones.

#include <Eigen/Core>
#include <Eigen/LU>

namespace signorini {

/// P A = L U with partial pivoting, A n x n and complex. Source: [golub2013], ch. 3.4.
class ComplexLuFactors {
 public:
  ComplexLuFactors() = default;
  explicit ComplexLuFactors(const Eigen::MatrixXcd& A);
  void compute(const Eigen::MatrixXcd& A);  ///< as LuFactors::compute

  [[nodiscard]] Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const;  ///< A^-1 b
  [[nodiscard]] Eigen::MatrixXcd solve(const Eigen::MatrixXcd& B) const;  ///< A^-1 B, n x k
  [[nodiscard]] Eigen::MatrixXcd inverse() const;
  [[nodiscard]] double reciprocal_condition() const;  ///< as LuFactors::reciprocal_condition

 private:
  Eigen::PartialPivLU<Eigen::MatrixXcd> lu_;
};

/// P A Q = L U with complete pivoting, A n x n and complex.
class CompleteComplexLuFactors {
 public:
  explicit CompleteComplexLuFactors(const Eigen::MatrixXcd& A);

  [[nodiscard]] Eigen::MatrixXcd solve(const Eigen::MatrixXcd& B) const;  ///< as CompleteLuFactors::solve
  [[nodiscard]] Eigen::MatrixXcd inverse() const;
  [[nodiscard]] double reciprocal_condition() const;  ///< as CompleteLuFactors::reciprocal_condition

 private:
  Eigen::FullPivLU<Eigen::MatrixXcd> lu_;
};

/// A^-1 b by partial pivoting, for one right-hand side; not finite where A is singular.
Eigen::VectorXcd lu_solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b);

/// A^-1 by partial pivoting; not finite where A is singular.
Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& A);

/// Rows up to which `invert` takes less than factors and an estimate of their condition: these are calls and
/// memory, not arithmetic.
inline constexpr int kMostInverted = 8;

/// A <- A^-1, of kMostInverted rows at most, by partial pivoting without a call for memory. \return false,
/// and A as it was, where a pivot is zero or not a number
[[nodiscard]] bool invert(Eigen::MatrixXcd& A);

/// Reciprocal condition of A in the 1-norm from A and A^-1, with |re| + |im| for a modulus and so up to twice
/// what it is; 0 where A^-1 is not finite.
double reciprocal_condition(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& inverse);

}  // namespace signorini
