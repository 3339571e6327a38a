#include "problems/linear_algebra/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <vector>

#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/lapack.hpp"

namespace signorini {

namespace {

Eigen::VectorXd no_values(Eigen::Index size) {
  return Eigen::VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN());
}

// LAPACK may loop for ever on NaN, and Eigen takes some matrices that are not finite for converged.
bool lower_finite(const Eigen::MatrixXd& A) {
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      if (!std::isfinite(A(i, j))) return false;
    }
  }
  return true;
}

// Whether A x = lambda B x has an answer; the Cholesky factor of B tells LAPACK, and Eigen does not look.
bool has_answer(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return lower_finite(A) && lower_finite(B) && (is_for_lapack(A) || CholeskyFactors(B).definite());
}

// Calls `solve(work, integers)` of a routine twice: for the sizes of its work space, then with it.
template <class Solve>
void with_work_space(const Solve& solve) {
  double best = 0.0;
  int best_integers = 0;
  solve(&best, -1, &best_integers, -1);
  std::vector<double> work(static_cast<std::size_t>(best));
  std::vector<int> integers(static_cast<std::size_t>(best_integers));
  solve(work.data(), static_cast<int>(work.size()), integers.data(), static_cast<int>(integers.size()));
}

SymmetricEigen symmetric_by_lapack(Eigen::MatrixXd A, char job) {
  const int n = static_cast<int>(A.rows());
  int info = 0;
  SymmetricEigen result{.values = Eigen::VectorXd(n), .vectors = {}};
  with_work_space([&](double* work, int size, int* integers, int integers_size) {
    dsyevd_(&job, "L", &n, A.data(), &n, result.values.data(), work, &size, integers, &integers_size, &info,
            1, 1);
  });
  result.converged = info == 0;
  if (job == 'V') result.vectors = std::move(A);
  return result;
}

SymmetricEigen symmetric_by_lapack(Eigen::MatrixXd A, Eigen::MatrixXd B, char job) {
  constexpr int kType = 1;  // A x = lambda B x
  const int n = static_cast<int>(A.rows());
  int info = 0;
  SymmetricEigen result{.values = Eigen::VectorXd(n), .vectors = {}};
  with_work_space([&](double* work, int size, int* integers, int integers_size) {
    dsygvd_(&kType, &job, "L", &n, A.data(), &n, B.data(), &n, result.values.data(), work, &size, integers,
            &integers_size, &info, 1, 1);
  });
  result.converged = info == 0;
  if (job == 'V') result.vectors = std::move(A);
  return result;
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
  if (is_for_lapack(A)) return symmetric_by_lapack(A, 'V');
  return taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A), true);
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  if (A.rows() == 0 || !lower_finite(A)) return no_values(A.rows());
  if (is_for_lapack(A)) return values_of(symmetric_by_lapack(A, 'N'), A.rows());
  return values_of(
      taken_from(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly), false), A.rows());
}

SymmetricEigen generalised_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!has_answer(A, B)) return {};
  if (is_for_lapack(A)) return symmetric_by_lapack(A, B, 'V');
  return taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B), true);
}

Eigen::VectorXd generalised_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.rows() == 0 || !has_answer(A, B)) return no_values(A.rows());
  if (is_for_lapack(A)) return values_of(symmetric_by_lapack(A, B, 'N'), A.rows());
  return values_of(
      taken_from(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, B, Eigen::EigenvaluesOnly),
                 false),
      A.rows());
}

}  // namespace signorini
