#pragma once
// GMRES without restart, for operators known only by their product.

#include <Eigen/Core>
#include <functional>

namespace signorini {

/// A linear operator by its product with a vector.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// What a Krylov solve came to.
struct KrylovSolve {
  Eigen::VectorXd x;       ///< empty where the tolerance was missed or a number is not finite
  double condition = 1.0;  ///< of A M^{-1}, estimated from the Krylov space: a lower bound [-]
};

/// Solves A x = b from x = 0 by right-preconditioned GMRES, modified Gram-Schmidt and one
/// reorthogonalisation, until |b - A x|_2 <= tolerance |b|_2 or the Krylov space has the full size of b.
/// Right preconditioning keeps the residual that of the system itself.
/// \param precondition v -> M^{-1} v
/// Source: [saad1986].
KrylovSolve solve_by_gmres(const LinearOperator& product, const LinearOperator& precondition,
                           const Eigen::VectorXd& b, double tolerance);

}  // namespace signorini
