#pragma once
// Contact receptances of large structures from one real factorisation.

#include <optional>

#include "methods/structure/contact_receptance.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Error of a projected receptance that may be left, relative to its norm: far below what a truncated series
/// leaves, and below any defect of energy that says something [-].
inline constexpr double kReducedTolerance = 1e-10;

/// `contact_receptance` by projection. With D = alpha M + beta K every dynamic stiffness is a combination of
/// the same two matrices, Z_n = kappa_n P + mu_n M, P = K + sigma M. On the basis V of the block Krylov space
/// of P^{-1} M from P^{-1} [W, loads] (`BlockLanczos`) it becomes Z_n ~ kappa_n + mu_n t, diagonal in the
/// eigenvectors of t, and
///
///     C_n = W^T V (kappa_n + mu_n t)^{-1} V^T W + E_n,    |E_n| <= rho_n^2 / d_n,
///
/// rho_n = |W - Z_n V y|_{P^{-1}}, the residual of the columns of W, which costs nothing to know, and
/// d_n = min |kappa_n + mu_n theta| over the spectrum of P^{-1} M, 0 <= theta <= the largest eigenvalue of t
/// [grimme1997]. The error is that of the residual squared because Z_n is symmetric and W is on both of its
/// sides. The space grows until rho_n^2 <= tolerance d_n |C_n|_F at every harmonic, and likewise for the
/// loads, whose scale is |f_n^* Z_n^{-1} f_n|.
///
/// With damping this is a bound, up to rounding in P^{-1} and as far as the largest eigenvalue is met, which
/// Lanczos' method finds first. Without damping at a harmonic, d_n is taken over the eigenvalues of t: an
/// estimate, blind to resonances that the contacts and loads have not excited in the space so far.
///
/// sigma is 0 where K is definite, else the square of the frequency of the lowest harmonic.
///
/// \return nothing where D is not proportional, where P is not definite, or once the space has cost more than
/// a
///         factorisation of every Z_n would: the direct solution is the better one
/// \throws SingularStiffness
std::optional<ContactReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance);

}  // namespace signorini
