#include "problems/linear_algebra/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/linear_algebra/cholesky.hpp"

namespace signorini {

namespace {

Eigen::VectorXd no_values(Eigen::Index size) {
  return Eigen::VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN());
}

// Eigen takes some matrices that are not finite for converged.
bool lower_finite(const Eigen::MatrixXd& A) {
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      if (!std::isfinite(A(i, j))) return false;
    }
  }
  return true;
}

// Whether A x = lambda B x has an answer; Eigen does not look.
bool has_answer(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return lower_finite(A) && lower_finite(B) && CholeskyFactors(B).definite();
}

template <class Solver>
SymmetricEigen taken_from(const Solver& solver, bool with_vectors) {
  SymmetricEigen result{
      .converged = solver.info() == Eigen::Success, .values = solver.eigenvalues(), .vectors = {}};
  if (with_vectors) result.vectors = solver.eigenvectors();
  return result;
}

Eigen::VectorXd values_of(SymmetricEigen found, Eigen::Index size) {
  return found.converged ? std::move(found.values) : no_values(size);
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!lower_finite(A)) return {};
  return taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A), true);
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  if (A.rows() == 0 || !lower_finite(A)) return no_values(A.rows());
  return values_of(
      taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly), false), A.rows());
}

SymmetricEigen generalised_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!has_answer(A, B)) return {};
  return taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B), true);
}

Eigen::VectorXd generalised_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0 || !has_answer(A, B)) return no_values(A.rows());
  return values_of(
      taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B, Eigen::EigenvaluesOnly),
                 false),
      A.rows());
}

}  // namespace signorini
