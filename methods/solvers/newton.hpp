#pragma once
// Semi-smooth Newton on the projected complementarity equations: the source paper's solver.

#include <chrono>

#include "methods/solvers/lcp.hpp"

namespace signorini {

/// Where Newton's method begins and when it must end.
struct NewtonOptions {
  int max_iterations = 100;    ///< steps [-]
  double tolerance = 1e-10;    ///< on LcpResult::residual [-]
  Eigen::VectorXd guess = {};  ///< z of a nearby problem; empty: the contact-free response
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Solves F(y) = max(0, -y) - q - A max(0, y) = 0, z = max(0, y), w = max(0, -y), by Newton's method with
/// a generalised Jacobian and a monotone line search on |F|_2 (halving down to 2^-20).
///
/// With y = c (x - g) - lambda this is the source paper's system [shi2015, eq. 23 and 36, corrected]: there
/// y lies in the Fourier space plus a constant, and so do all Newton iterates here, so that the active set
/// {y > 0}, the iterates and the full steps are the paper's own. Each step solves one dense |active|
/// system, A_SS z_S = -q_S. Converges locally only; failure is reported, not repaired.
LcpResult solve_by_newton(const Lcp& lcp, const NewtonOptions& options = {});

}  // namespace signorini
