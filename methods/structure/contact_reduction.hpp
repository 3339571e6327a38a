#pragma once
// A structure reduced to what its contacts feel: a few Ritz vectors, and statically all the rest.

#include <Eigen/Core>

#include "methods/discretisation/symbols.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/bases/reduced_structure.hpp"
#include "methods/structure/contact_receptance.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Vectors of a reduction to modes of which no number is asked [-].
inline constexpr int kModes = 100;

/// Which vectors a reduction keeps.
enum class ReductionBasis {
  automatic,  ///< krylov while six powers of contacts and loads have at most 300 columns, else modes
  krylov,     ///< all Ritz vectors of the Krylov space of K^-1 M from K^-1 [W, f] [grimes1994]
  modes,      ///< the lowest Ritz vectors of the Krylov space from K^-1 [f, random columns]
};

/// What `reduce_to_contacts` keeps.
struct ReductionSettings {
  ReductionBasis basis = ReductionBasis::automatic;  ///< of which space
  /// m at least (krylov: whole powers are taken) or exactly (modes), where the structure has that many; 0:
  /// six powers and at least 60 vectors (krylov), 100 (modes) [-]
  int vectors = 0;
};

/// The reduction of a scene, for contacts of any law. Massless coordinates are eliminated first: the space
/// starts from the directions N on coordinates with mass, so that all its vectors move the massless
/// coordinates statically and none of infinite frequency is in it. One Cholesky factorisation of K, at most
/// one solution per vector, contact and load; the Krylov space needs no solution beyond its own, since W^T
/// K^-1 W is in it. Deterministic.
///
/// The Krylov space is the better one by orders of magnitude where it has six powers and damping grows with
/// the stiffness; of many contacts it would be too large, and modes converge as the residual does.
///
/// Of 400 coordinates at most, of 2000 where it is a full matrix, damping that is not proportional but does
/// not couple modes either is taken too: then all modes are kept, whatever the settings (`modal_reduction`).
///
/// An obstacle: other damping, K not positive definite, neither contacts nor loads.
ContactReduction reduce_to_contacts(const Problem& problem, const ReductionSettings& settings = {});

/// The reduction in the form of a condensed structure: M = 1, D = d, K = omega^2, N the rows, relaxing with
/// beta. `kept` is empty, for its coordinates are none of the scene.
CondensedStructure condensed(const ContactReduction& reduction);

/// C_n and free response of the reduced structure, n = 0..H:
///
///     C_n = sum_k n_k n_k^T / z_k + C_m / (w_K + beta w_D),
///     z_k = w_M + d_k w_D + omega_k^2 w_K,
///
/// w the weights of harmonic n. Loads above harmonic H are dropped.
/// \param period  of the motion, a whole multiple of the load's [s]
/// \throws SingularStiffness where some z_k vanishes to rounding
ContactReceptance contact_receptance(const ContactReduction& reduction, double period, int harmonics,
                                     const WeightsOfHarmonic& weights);

/// x_n of the reduced structure under its load and a contact force, n = 0..H, (H+1) x Nc [m]: what
/// `contact_receptance` says of exact time, without a matrix per harmonic.
/// \param base   rate of harmonic 1, a whole part of the load's [rad/s]
/// \param force  lambda_n, (H+1) x Nc [N]
/// \throws SingularStiffness where some z_k vanishes to rounding
Eigen::MatrixXcd contact_response(const ContactReduction& reduction, double base,
                                  const Eigen::MatrixXcd& force);

}  // namespace signorini
