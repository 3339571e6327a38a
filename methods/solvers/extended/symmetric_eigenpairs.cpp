#include "methods/solvers/extended/symmetric_eigenpairs.hpp"

#include <Eigen/Eigenvalues>

namespace signorini::extended {

std::optional<SymmetricEigenpairs> symmetric_eigenpairs(const ExtendedMatrix& A) {
  if (A.rows() == 0) return SymmetricEigenpairs{};
  if (!all_finite(A)) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<ExtendedMatrix> solver(A);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return SymmetricEigenpairs{.values = {solver.eigenvalues().begin(), solver.eigenvalues().end()},
                             .vectors = solver.eigenvectors()};
}

}  // namespace signorini::extended
