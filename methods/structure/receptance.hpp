#pragma once
// The linear structure in the frequency domain, reduced to its contacts [shi2015, section 5].

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "methods/discretisation/symbols.hpp"
#include "methods/structure/bases/reduced_structure.hpp"
#include "methods/structure/contact_receptance.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// x_n = free_n + C_n lambda_n, n = 0..H: the motion at the contacts under their forces, (H+1) x Nc [m].
/// \param lambda  coefficients of the contact forces, n = 0..H at least, Nc columns [N]
Eigen::MatrixXcd contact_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda);

/// Whether a contact answers like a mass beyond harmonic n: from there to H its C_n n^2 is -a within a half
/// of it, a > 0 that of C_H.
bool is_mass_beyond(const ContactReceptance& receptance, int contact, int harmonic);

/// How contacts answer to fast forces, C_n -> -a / n^2 - i b / n^3, a and b of size Nc x Nc [m/N].
struct InertialLimit {
  Eigen::MatrixXd a = {};  ///< W^T M^-1 W over the square of the base frequency
  Eigen::MatrixXd b = {};  ///< W^T M^-1 D M^-1 W over its third power
};

/// Extrapolated from C_H/2 and C_H, H >= 1: where all modes lie far below H the error falls with its fourth
/// power. What modes above H have of the mass is missing.
InertialLimit inertial_limit(const ContactReceptance& receptance);

/// A receptance, and the structure reduced to what its contacts feel where that was the way to it.
struct ReducedReceptance {
  ContactReceptance value;  ///< C_n, n = 0..H [m/N]
  /// The lowest vectors of the space that the receptance was found on, 100 at most, with the static residual
  /// of all others, or all modes; with an obstacle where it was factorised, or K is singular.
  ContactReduction reduction;
};

/// contact_motion at N equidistant nodes of a period under nodal forces: x_n = free_n + C_n lambda_n, n =
/// 0..N/2, lambda_n the discrete Fourier coefficients of the forces; N x Nc [m]. \param receptance  with
/// harmonics 0..N/2 at least \param force       lambda, N x Nc [N]
Eigen::MatrixXd nodal_response(const ContactReceptance& receptance, const Eigen::MatrixXd& force);

/// `contact_receptance` by factorising Z_n for every n = 0..H, O(Nd^3) each if `dense`, else as sparse LU
/// allows. Right-hand sides are solved for a few at a time, so that memory is that of the factors.
/// \throws SingularStiffness
ContactReceptance factorised_receptance(const Problem& problem, int harmonics,
                                        const WeightsOfHarmonic& weights, bool dense);

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
/// loads, whose scale is |f_n^* Z_n^{-1} f_n|. While it grows it is looked at harmonics that rise by a tenth;
/// at the end at all of them.
///
/// With damping this is a bound, up to rounding in P^{-1} and as far as the largest eigenvalue is met, which
/// Lanczos' method finds first. Without damping at a harmonic, d_n is taken over the eigenvalues of t: an
/// estimate, blind to resonances that the contacts and loads have not excited in the space so far. A
/// harmonic between modes that nothing damps, as the highest of a grid, wants a space that holds nearly all
/// of them: harmonics that cost less to factorise than the space has cost so far are factorised.
///
/// sigma is 0 where K is definite, else the square of the frequency of the lowest harmonic.
///
/// \return nothing where D is not proportional, where P is not definite, or once the space has cost more than
///         a factorisation of every Z_n would: the direct solution is the better one
/// \throws SingularStiffness
std::optional<ReducedReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance);

/// C_n and free response for n = 0..H under the discretisation that gives harmonic n its weights.
/// Loads above harmonic H of the base frequency are dropped. Factorised (`factorised_receptance`), by dense
/// factors up to 32 coordinates, to 2000, and where the damping is not proportional or projection turns out
/// to cost more; else reduced, with an error of at most 1e-10 |C_n|_F. To 2000 coordinates, a full damping
/// matrix that does not couple the modes: by these (`modal_reduction`). \throws SingularStiffness
ContactReceptance contact_receptance(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights);

/// The same, with the reduced structure that it was found on.
ReducedReceptance reduced_contact_receptance(const Problem& problem, int harmonics,
                                             const WeightsOfHarmonic& weights);

/// C_n and free response of the undiscretised structure for n = 0..H. \throws SingularStiffness
ContactReceptance fourier_receptance(const Problem& problem, int harmonics);

}  // namespace signorini
