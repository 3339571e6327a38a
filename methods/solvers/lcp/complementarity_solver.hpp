#pragma once
// The solvers of the complementarity methods: Lemke's method as a homotopy in the gap, on the active set
// alone, with restarts; or the source paper's Newton method.

#include <Eigen/Core>
#include <optional>

#include "methods/solvers/lcp/lcp.hpp"

namespace signorini {

/// Covering vector with one smooth wave per period, d_{c,i} = 1 + amplitude * cos(2 pi i / N + phase), and
/// an irregular part of size 1e-9 that separates the ties of symmetric problems, where pivoting could cycle.
/// With amplitude 0 it does not depend on how the unknowns divide into samples and contacts.
/// \param amplitude  in [0, 1) [-]
/// \param phase      [rad]
/// \return d > 0, samples * contacts [-]
Eigen::VectorXd smooth_cover(int samples, int contacts, double amplitude = 0.0, double phase = 0.0);

/// The d for which max(0, guess) solves w = q + tau d + A z at tau = 1: there w = 0 wherever the guess is
/// positive, and w at least a thousandth of max |q| elsewhere, so that no other index is near its bound.
/// \param guess  z of a nearby problem, size of q
Eigen::VectorXd cover_through(const Lcp& lcp, const Eigen::VectorXd& guess);

/// Follows the solution of w = q + tau d + A z, z >= 0, w >= 0, z^T w = 0 from a tau so large that z = 0
/// (every gap is open) down to tau = 0. With d = 1 the parameter is an added gap. The path is piecewise
/// linear; each pivot updates the QR factors of the bordered active block [A_RB, d_R], one row and column
/// larger than the number of positive z: per pivot O(|active|^2) and |active| columns of A, memory of vectors
/// and of |active|^2.
///
/// The default d is constant but for one part in 1e9 of irregular variation, which separates the ties of
/// symmetric problems, where pivoting could cycle. The answer depends on d only in which of several
/// solutions is met first; the path's length depends on it strongly: a d that is rough in time excites
/// high harmonics all along, smooth ones do not (docs/decisions/0005).
/// Warm start: d is chosen so that the guess solves the problem at tau = 1, and the path begins there.
///
/// Guarantee: `solved` means residual <= tolerance. With strictly copositive-plus A no ray can occur
/// [cottle2009, theorem 4.4.12]; for the periodic contact problems see docs/theory.md.
/// \param settings  limit 6000 + 10 * size pivots unless told; its wave is that of a cold path's d
/// \param guess     warm start: z of a nearby problem; empty: cold
LcpResult solve_by_pivoting(const Lcp& lcp, const SolverSettings& settings = {},
                            const Eigen::VectorXd& guess = {});

/// Solves F(y) = max(0, -y) - q - A max(0, y) = 0, z = max(0, y), w = max(0, -y), by Newton's method with
/// a generalised Jacobian and a monotone line search on |F|_2 (halving down to 2^-20).
///
/// With y = c (x - g) - lambda this is the source paper's system [shi2015, eq. 23 and 36, corrected]: there
/// y lies in the Fourier space plus a constant, and so do all Newton iterates here, so that the active set
/// {y > 0}, the iterates and the full steps are the paper's own. Each step solves one |active| system, A_SS
/// z_S = -q_S, dense up to 600 unknowns, beyond by at most 300 steps of GMRES. Converges locally only;
/// failure is reported, not repaired.
/// \param settings  limit 100 steps unless told
/// \param guess     z of a nearby problem; empty: the contact-free response
LcpResult solve_by_newton(const Lcp& lcp, const SolverSettings& settings = {},
                          const Eigen::VectorXd& guess = {});

/// The same from an iterate y, of the size of q. y = -q is the contact-free response.
LcpResult solve_by_newton_from(const Lcp& lcp, const SolverSettings& settings, Eigen::VectorXd y);

/// The solution with z > 0 everywhere, if there is one: permanent contact, which a path of pivots would reach
/// last, having met rattling motions on its way. One linear solve, where a contact presses on average.
/// \param tolerance  on LcpResult::residual [-]
std::optional<LcpResult> permanent_contact(const Lcp& lcp, double tolerance);

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
