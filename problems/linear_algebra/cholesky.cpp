#include "problems/linear_algebra/cholesky.hpp"

#include <cmath>

namespace signorini {

CholeskyFactors::CholeskyFactors(const Eigen::MatrixXd& A) : factors_(A) {}

bool CholeskyFactors::definite() const {
  if (factors_.info() != Eigen::Success) return false;
  // NaN passes Eigen's test of the pivots, and reaches the diagonal.
  for (Eigen::Index i = 0; i < factors_.rows(); ++i) {
    if (!std::isfinite(factors_.matrixLLT()(i, i))) return false;
  }
  return true;
}

Eigen::VectorXd CholeskyFactors::solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

Eigen::MatrixXd CholeskyFactors::solve(const Eigen::MatrixXd& B) const { return factors_.solve(B); }

Eigen::MatrixXd CholeskyFactors::inverse() const {
  return factors_.solve(Eigen::MatrixXd::Identity(factors_.rows(), factors_.cols()));
}

double CholeskyFactors::reciprocal_condition() const { return factors_.rcond(); }

Eigen::MatrixXd CholeskyFactors::upper_times(const Eigen::MatrixXd& B) const {
  return factors_.matrixU() * B;
}

void CholeskyFactors::normalise_columns(Eigen::MatrixXd& B) const {
  factors_.matrixU().solveInPlace<Eigen::OnTheRight>(B);
}

Eigen::VectorXd ldlt_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) { return A.ldlt().solve(b); }

}  // namespace signorini
