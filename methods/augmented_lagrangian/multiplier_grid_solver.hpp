#pragma once
// Penalty solves inside, updates of the multiplier outside.

#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/solvers/lcp/lcp.hpp"

namespace signorini {

/// rho over the highest dynamic stiffness where it is left to the method: an update then leaves less than a
/// sixth of an error, up to H = 20 [-].
inline constexpr double kAugmentedMultiple = 32.0;

/// Solves the projected equations of a law (rho, alpha) with the multiplier mu taken out of the contact
/// condition [alart1991]:
///
///     lambda = -P max(0, rho (x - g) - alpha mu),   x = x_f + C lambda,   mu <- lambda,
///
/// the first by Newton's method with the exact contact integral (project_exactly) for a given mu, the second
/// until lambda solves the projected equations themselves, whose residual is the one accepted. So the fixed
/// points are exactly the solutions of the Lipschitz form with c = rho. Near one an error shrinks, or grows,
/// by the spectral radius of (1 + rho P chi C)^{-1} alpha P chi per update, chi the indicator of contact: the
/// larger rho, the faster, and not at all where C makes it exceed 1. A stop that is a spring of stiffness rho
/// has alpha = 0 and needs no update.
///
/// It begins, unless at forces or a motion given, at the solution of the penalty rho with mu = 0, which it
/// reaches through rising penalties, in factors of two or smaller ones where Newton's method does not follow,
/// from one of the size of the highest dynamic stiffness that pivoting on the samples solves. Updates are
/// accelerated (AndersonAcceleration), which converges where the update itself runs away, and are taken in
/// part where Newton's method does not follow. From a force given that it does not follow at all, penalties
/// rise from soft ones, solved from that force.
///
/// `plain` is the literature's form: the first penalty is soft beside the structure and solved from the
/// motion without contact forces, and updates are taken as they stand.
///
/// \param settings  tolerance on the residual; limit on Newton steps, asked for between updates
/// \param updates   of the multiplier, at most
GridSolver multiplier_grid_solver(const SolverSettings& settings, int updates, bool plain = false);

}  // namespace signorini
