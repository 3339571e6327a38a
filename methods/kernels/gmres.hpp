#pragma once
// GMRES without restart, for operators known only by their product.

#include <Eigen/Core>
#include <functional>

namespace signorini {

using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Solves A x = b from x = 0 by right-preconditioned GMRES, modified Gram-Schmidt and one
/// reorthogonalisation, until |b - A x|_2 <= tolerance |b|_2 or the Krylov space has the full size of b.
/// Right preconditioning keeps the residual that of the system itself.
/// \param precondition v -> M^{-1} v
/// \return x; empty where the tolerance was missed or a number is not finite.
/// Source: [saad1986].
Eigen::VectorXd solve_by_gmres(const LinearOperator& product, const LinearOperator& precondition,
                               const Eigen::VectorXd& b, double tolerance);

}  // namespace signorini
