#pragma once
// The gap homotopy of the alternating frequency/time equations, followed switch by switch.

#include <Eigen/Core>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/method.hpp"

namespace signorini {

struct NewtonKrylov {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;   ///< |R|_2 relative to the larger of |P max(0, y)|_2 and the load scale [-]
  Eigen::VectorXd lambda;  ///< best iterate
};

/// Newton on R(lambda) = 0 with GMRES for each step and a monotone line search on |R|_2 (halving down
/// to 2^-16). The equations are piecewise linear: near a solution one full step ends it.
NewtonKrylov solve_newton_krylov(AftResidual& residual, Eigen::VectorXd lambda, double tolerance,
                                 int max_iterations, const Start& start);

struct GapPath {
  enum class End { arrived, ray, limit, singular, interrupted } end = End::limit;
  int switches = 0;        ///< samples that opened or closed on the way
  Eigen::VectorXd lambda;  ///< at tau = 0 where it arrived
};

/// Follows R(lambda, tau) = 0 from the gap shift tau at which the first sample touches (lambda = 0) to
/// tau = 0. Between two switches of a sample the equations are linear: one bordered solve
///
///     J v - s P chi d = 0,     (B v - s d)_i = +1 (sample i has just closed) or -1 (just opened)
///
/// gives the direction (regular at folds of the path too), and the next sample to switch ends the piece.
/// This is Lemke's path walked in the frequency domain: same guarantee, no matrix.
GapPath follow_gap_path(AftResidual& residual, int max_switches, const Start& start);

}  // namespace signorini
