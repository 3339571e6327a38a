#pragma once
// What solves with a large symmetric positive definite matrix.

#include <Eigen/Core>
#include <functional>
#include <memory>

#include "problems/structure.hpp"

namespace signorini {

/// A factorised A, Nd x Nd.
class DefiniteSolver {
 public:
  virtual ~DefiniteSolver() = default;
  /// Whether A is positive definite by more than rounding.
  [[nodiscard]] virtual bool definite() const = 0;
  /// A^{-1} rhs, Nd x k. A is positive definite.
  [[nodiscard]] virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) = 0;
  /// Numbers kept in the factor.
  [[nodiscard]] virtual double entries() const = 0;
  /// Floating-point operations of the factorisation.
  [[nodiscard]] virtual double operations() const = 0;
};

/// Factorises a symmetric matrix, of which the lower triangle is looked at.
/// \throws std::bad_alloc where memory does not suffice
using Factorise = std::function<std::unique_ptr<DefiniteSolver>(const SparseMatrix& A)>;

/// In this process, by `SparseCholesky`.
std::unique_ptr<DefiniteSolver> factorise_here(const SparseMatrix& A);

}  // namespace signorini
