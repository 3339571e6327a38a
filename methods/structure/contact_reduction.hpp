#pragma once
// A structure reduced to what its contacts feel: a few Ritz vectors, and statically all the rest.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "methods/discretisation/symbols.hpp"
#include "methods/structure/condensation.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// A structure with D = alpha M + beta K on m vectors phi_k, phi_k^T M phi_k = 1, phi_k^T K phi_k =
/// omega_k^2, orthogonal in both. With n_k = W^T phi_k,
///
///     q_k'' + (alpha + beta omega_k^2) q_k' + omega_k^2 q_k = phi_k^T f + n_k^T lambda,
///     x = sum_k n_k q_k + xi,    beta xi' + xi = s_m(t) + C_m lambda,
///     C_m = W^T K^-1 W - sum_k n_k n_k^T / omega_k^2,    s_m = W^T K^-1 f - sum_k n_k phi_k^T f / omega_k^2.
///
/// What the vectors leave out follows statically, as MacNeal's residual flexibility does [macneal1971]; with
/// damping it relaxes with the time beta, which is right for waves far above omega_m and far below. So no
/// coordinate of a contact has mass of its own [monjaraz2022], and the motion of massless contacts needs no
/// impact law. C_m is positive semi-definite, and not smaller than the compliance of the massless
/// coordinates.
///
/// Contacts that have mass and an impact law become another model, whose mass at the contact is that of the
/// vectors: only a start for one of the whole structure.
struct ContactReduction {
  std::string obstacle;         ///< why this cannot be done, one clause; the rest is then empty
  ProportionalDamping damping;  ///< alpha [1/s], beta [s]
  Eigen::VectorXd squares;      ///< omega_k^2 > 0, rising, m [1/s^2]
  Eigen::MatrixXd rows;         ///< row k is n_k^T, m x Nc [kg^-1/2]
  Eigen::MatrixXd compliance;   ///< C_m, Nc x Nc [m/N]
  /// h omega of the harmonics in the load, ascending, 0 always the first [rad/s].
  std::vector<double> rates;
  Eigen::MatrixXcd load;   ///< phi_k^T f of e^{i h omega t}, its real part to be taken; m x Nh [N kg^-1/2]
  Eigen::MatrixXcd shift;  ///< s_m likewise, Nc x Nh [m]
  bool complete = false;   ///< whether the vectors span all that contacts and loads can excite

  /// m.
  [[nodiscard]] Eigen::Index vectors() const { return squares.size(); }
  /// Nc.
  [[nodiscard]] Eigen::Index contacts() const { return compliance.rows(); }
};

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
/// An obstacle: damping that is not proportional, K not positive definite, neither contacts nor loads.
ContactReduction reduce_to_contacts(const Problem& problem, const ReductionSettings& settings = {});

/// The reduction in the form of a condensed structure: M = 1, D = alpha + beta omega^2, K = omega^2, N the
/// rows, relaxing with beta. `kept` is empty, for its coordinates are none of the scene.
CondensedStructure condensed(const ContactReduction& reduction);

/// C_n and free response of the reduced structure, n = 0..H:
///
///     C_n = sum_k n_k n_k^T / z_k + C_m / (w_K + beta w_D),
///     z_k = w_M + (alpha + beta omega_k^2) w_D + omega_k^2 w_K,
///
/// w the weights of harmonic n. Loads above harmonic H are dropped.
/// \param period  of the motion, a whole multiple of the load's [s]
/// \throws SingularStiffness where some z_k vanishes to rounding
ContactReceptance contact_receptance(const ContactReduction& reduction, double period, int harmonics,
                                     const WeightsOfHarmonic& weights);

}  // namespace signorini
