#pragma once
// Newton's method with Krylov steps on the alternating frequency/time equations.

#include <Eigen/Core>
#include <optional>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/method.hpp"

namespace signorini {

struct NewtonKrylov {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;   ///< |R|_2 relative to the larger of |P max(0, y)|_2 and the load scale [-]
  Eigen::VectorXd lambda;  ///< best iterate
  std::optional<double> condition = {};  ///< estimate for the preconditioned Jacobian of the last step [-]
};

/// Newton on R(lambda) = 0 with GMRES for each step and a monotone line search on |R|_2 (halving down
/// to 2^-16). The equations are piecewise linear: near a solution one full step ends it.
NewtonKrylov solve_newton_krylov(AftResidual& residual, Eigen::VectorXd lambda, double tolerance,
                                 int max_iterations, const Start& start);

}  // namespace signorini
