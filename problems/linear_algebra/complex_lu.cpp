#include "problems/linear_algebra/complex_lu.hpp"

namespace signorini {

ComplexLuFactors::ComplexLuFactors(const Eigen::MatrixXcd& A) : lu_(A) {}

void ComplexLuFactors::compute(const Eigen::MatrixXcd& A) { lu_.compute(A); }

Eigen::VectorXcd ComplexLuFactors::solve(const Eigen::VectorXcd& b) const { return lu_.solve(b); }

Eigen::MatrixXcd ComplexLuFactors::solve(const Eigen::MatrixXcd& B) const { return lu_.solve(B); }

Eigen::MatrixXcd ComplexLuFactors::inverse() const { return lu_.inverse(); }

double ComplexLuFactors::reciprocal_condition() const {
  // Behind a pivot that is zero the estimate is made of what division by it leaves.
  if (lu_.rows() > 0 && lu_.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) return 0.0;
  return lu_.rcond();
}

CompleteComplexLuFactors::CompleteComplexLuFactors(const Eigen::MatrixXcd& A) : lu_(A) {}

Eigen::MatrixXcd CompleteComplexLuFactors::solve(const Eigen::MatrixXcd& B) const { return lu_.solve(B); }

Eigen::MatrixXcd CompleteComplexLuFactors::inverse() const { return lu_.inverse(); }

double CompleteComplexLuFactors::reciprocal_condition() const { return lu_.rcond(); }

Eigen::VectorXcd lu_solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) {
  return ComplexLuFactors(A).solve(b);
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& A) { return ComplexLuFactors(A).inverse(); }

}  // namespace signorini
