#include "problems/linear_algebra/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/lapack.hpp"

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

/// By divide and conquer [anderson1999], of A x = lambda B x where B is given. \param job  as of dsyevd
SymmetricEigen found_by_lapack(const Eigen::MatrixXd& A, char job, const Eigen::MatrixXd* B = nullptr) {
  constexpr char kLower = 'L';
  constexpr int kKind = 1;
  const auto n = static_cast<int>(A.rows());
  SymmetricEigen result{.converged = false, .values = Eigen::VectorXd(n), .vectors = A};
  Eigen::MatrixXd factor;
  if (B != nullptr) factor = *B;
  int info = 0;
  const auto solve = [&](double* work, int size, int* integers, int integers_size) {
    if (B == nullptr)
      dsyevd_(&job, &kLower, &n, result.vectors.data(), &n, result.values.data(), work, &size, integers,
              &integers_size, &info, 1, 1);
    else
      dsygvd_(&kKind, &job, &kLower, &n, result.vectors.data(), &n, factor.data(), &n, result.values.data(),
              work, &size, integers, &integers_size, &info, 1, 1);
  };
  double best = 0.0;
  int best_integers = 0;
  solve(&best, -1, &best_integers, -1);
  std::vector<double> work(static_cast<std::size_t>(best));
  std::vector<int> integers(static_cast<std::size_t>(best_integers));
  solve(work.data(), static_cast<int>(work.size()), integers.data(), best_integers);
  result.converged = info == 0;
  return result;
}

SymmetricEigen symmetric_pairs(const Eigen::MatrixXd& A, bool with_vectors) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!lower_finite(A)) return {};
  if (A.rows() >= kLeastForLapack) return found_by_lapack(A, with_vectors ? 'V' : 'N');
  const int options = with_vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly;
  return taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, options), with_vectors);
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) { return symmetric_pairs(A, true); }

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  SymmetricEigen found = symmetric_pairs(A, false);
  if (found.converged) return std::move(found.values);
  return Eigen::VectorXd::Constant(A.rows(), std::numeric_limits<double>::quiet_NaN());
}

SymmetricEigen generalised_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!lower_finite(A) || !lower_finite(B) || !CholeskyFactors(B).definite())
    return {};  // Eigen does not look
  if (A.rows() >= kLeastForLapack) return found_by_lapack(A, 'V', &B);
  return taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B), true);
}

}  // namespace signorini
