#include "problems/linear_algebra/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/linear_algebra/cholesky.hpp"

namespace signorini {

namespace {

// Eigen takes some matrices that are not finite for converged.
bool lower_finite(const Eigen::MatrixXd& A) {
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      if (!std::isfinite(A(i, j))) return false;
    }
  }
  return true;
}

template <class Solver>
SymmetricEigen taken_from(const Solver& solver, bool with_vectors) {
  SymmetricEigen result{
      .converged = solver.info() == Eigen::Success, .values = solver.eigenvalues(), .vectors = {}};
  if (with_vectors) result.vectors = solver.eigenvectors();
  return result;
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!lower_finite(A)) return {};
  return taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A), true);
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  SymmetricEigen found;
  if (A.rows() > 0 && lower_finite(A))
    found = taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly), false);
  if (found.converged) return std::move(found.values);
  return Eigen::VectorXd::Constant(A.rows(), std::numeric_limits<double>::quiet_NaN());
}

SymmetricEigen generalised_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!lower_finite(A) || !lower_finite(B) || !CholeskyFactors(B).definite())
    return {};  // Eigen does not look
  return taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B), true);
}

}  // namespace signorini
