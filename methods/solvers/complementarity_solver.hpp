#pragma once
// The solvers of the complementarity methods: pivoting with restarts, or the source paper's Newton method.

#include <Eigen/Core>

#include "methods/solvers/lcp.hpp"

namespace signorini {

/// Solves F(y) = max(0, -y) - q - A max(0, y) = 0, z = max(0, y), w = max(0, -y), by Newton's method with
/// a generalised Jacobian and a monotone line search on |F|_2 (halving down to 2^-20).
///
/// With y = c (x - g) - lambda this is the source paper's system [shi2015, eq. 23 and 36, corrected]: there
/// y lies in the Fourier space plus a constant, and so do all Newton iterates here, so that the active set
/// {y > 0}, the iterates and the full steps are the paper's own. Each step solves one dense |active|
/// system, A_SS z_S = -q_S. Converges locally only; failure is reported, not repaired.
/// \param settings  limit 100 steps unless told
/// \param guess     z of a nearby problem; empty: the contact-free response
LcpResult solve_by_newton(const Lcp& lcp, const SolverSettings& settings = {},
                          const Eigen::VectorXd& guess = {});

/// The same from an iterate y, of the size of q. y = -q is the contact-free response.
LcpResult solve_by_newton_from(const Lcp& lcp, const SolverSettings& settings, Eigen::VectorXd y);

/// Solves the problem as the settings ask, from `guess` (z of a nearby problem) or cold when that is empty.
/// `automatic` makes these attempts, in this order, until one succeeds:
///
///   1. without a guess: permanent contact, w = 0 everywhere, one linear solve;
///   2. pivoting from the guess, if there is one; then cold;
///   3. where a path ends on a ray or at a singular block: cold with four other covering vectors.
///
/// `pivoting` makes the second alone, `newton` none of them. Counts of work are summed over attempts.
LcpResult solve_lcp(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess = {});

}  // namespace signorini
