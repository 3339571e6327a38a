#include "problems/linear_algebra/general_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <complex>
#include <limits>
#include <vector>

#include "problems/linear_algebra/lapack.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

GeneralEigen general_by_lapack(Eigen::MatrixXd A, char job) {
  const int n = static_cast<int>(A.rows()), one = 1;
  Eigen::VectorXd real(n), imaginary(n);
  Eigen::MatrixXd parts(job == 'V' ? n : 0, job == 'V' ? n : 0);
  int info = 0;
  const auto solve = [&](double* work, int size) {
    dgeev_("N", &job, &n, A.data(), &n, real.data(), imaginary.data(), nullptr, &one, parts.data(), &n, work,
           &size, &info, 1, 1);
  };
  double best = 0.0;
  solve(&best, -1);
  std::vector<double> work(static_cast<std::size_t>(best));
  solve(work.data(), static_cast<int>(work.size()));
  GeneralEigen result{.converged = info == 0, .values = Eigen::VectorXcd(n), .vectors = {}};
  for (int k = 0; k < n; ++k) result.values[k] = {real[k], imaginary[k]};
  if (job == 'N') return result;
  result.vectors.resize(n, n);
  for (int k = 0; k < n; ++k) {
    if (imaginary[k] == 0.0) {
      for (int i = 0; i < n; ++i) result.vectors(i, k) = parts(i, k);
      continue;
    }
    for (int i = 0; i < n; ++i) {  // a pair: the real part, then the imaginary one
      result.vectors(i, k) = Complex(parts(i, k), parts(i, k + 1));
      result.vectors(i, k + 1) = std::conj(result.vectors(i, k));
    }
    ++k;
  }
  return result;
}

}  // namespace

GeneralEigen general_eigen(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!A.allFinite()) return {};
  if (is_for_lapack(A)) return general_by_lapack(A, 'V');
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) return {};
  return {.converged = true, .values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const GeneralEigen found = [&]() -> GeneralEigen {
    if (A.rows() == 0 || !A.allFinite()) return {};
    if (is_for_lapack(A)) return general_by_lapack(A, 'N');
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, false);
    return {.converged = solver.info() == Eigen::Success, .values = solver.eigenvalues(), .vectors = {}};
  }();
  return found.converged ? found.values : Eigen::VectorXcd::Constant(A.rows(), Complex(kNone, kNone));
}

}  // namespace signorini
