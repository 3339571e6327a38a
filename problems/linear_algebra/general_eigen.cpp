#include "problems/linear_algebra/general_eigen.hpp"

#include <Eigen/Eigenvalues>
#include <complex>
#include <limits>

namespace signorini {

GeneralEigen general_eigen(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return {.converged = true, .values = {}, .vectors = {}};
  if (!A.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) return {};
  return {.converged = true, .values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

Eigen::VectorXcd general_eigenvalues(const Eigen::MatrixXd& A) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const GeneralEigen found = [&]() -> GeneralEigen {
    if (A.rows() == 0 || !A.allFinite()) return {};
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, false);
    return {.converged = solver.info() == Eigen::Success, .values = solver.eigenvalues(), .vectors = {}};
  }();
  return found.converged ? found.values
                         : Eigen::VectorXcd::Constant(A.rows(), std::complex<double>(kNone, kNone));
}

double largest_magnitude(const Eigen::VectorXcd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

}  // namespace signorini
