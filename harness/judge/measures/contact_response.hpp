#pragma once
// The response of the structure to a periodic contact force, at the coordinates where forces act.

#include <Eigen/Core>
#include <optional>

#include "methods/reduction/contact_space.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The response of `PeriodicResponse`, reduced to where forces act: x_n = W^T u_n and q_n = F^T u_n, with
/// F phi_n the load of harmonic n. Memory holds (H+1) x (Nc + Nf) numbers and, for one harmonic at a time,
/// Z_n; Nf, the number of columns of F, is at most twice the number of harmonics in the load.
///
/// Beyond 2000 coordinates x and q come from a ContactSpace where one is given, grown for these forces, and
/// its bound holds: x to 1e-8 of its size, the work of the contact force to 1e-6 of the load's. Else from the
/// receptances of [W, F] by projection (`reduced_receptance`), with an error of 1e-10 of their norm, unless
/// factorising every Z_n costs less.
class ContactResponse {
 public:
  /// The response to the load and a contact force in H harmonics. \throws SingularStiffness if Z_n is
  /// singular at a harmonic with load or force, beyond rigid motions at harmonic 0 \param space  of this
  /// problem; null: none is known
  ContactResponse(const Problem& problem, ForceSeries series, const ContactSpace* space = nullptr);

  /// H.
  [[nodiscard]] int harmonics() const { return static_cast<int>(x_.rows()) - 1; }
  /// x_n, n = 0..H, (H+1) x Nc [m].
  [[nodiscard]] const Eigen::MatrixXcd& coefficients() const { return x_; }
  /// x at count instants of the period, count x Nc [m].
  [[nodiscard]] Eigen::MatrixXd displacement(int count) const;
  /// x under the load alone, without contact force, count x Nc [m].
  [[nodiscard]] Eigen::MatrixXd free_displacement(int count) const;
  /// Whether rigid motions leave the mean open: that of x and of the free motion is then of structures held.
  [[nodiscard]] bool mean_is_free() const { return mean_is_free_; }
  /// Work of the load per period, integral of f^T u' dt [J].
  [[nodiscard]] double work_of_load() const;
  /// Upper bound of |work_of_load()|: that of loads on displacements of these magnitudes, or of those under
  /// the load alone, in any phase [J]. Where contacts hold what is loaded, displacements are round-off, the
  /// motion that they prevent is not.
  [[nodiscard]] double largest_work_of_load() const;
  /// Whether the work of the load is more than round-off leaves of it: 1e-12 of the largest.
  [[nodiscard]] bool load_works() const;
  /// Work of the contact force per period and contact, integral of lambda_j x_j' dt [J], Nc.
  [[nodiscard]] Eigen::VectorXd contact_work() const;
  /// Work that D takes less what a skew part of K feeds per period, integral of u'^T (D u' + K u) dt [J].
  /// Where u is not computed, by projection: what load and contacts put in, the same at every harmonic.
  [[nodiscard]] double dissipation() const;

 private:
  [[nodiscard]] bool take(const ContactSpace& space);
  [[nodiscard]] bool take_grown(const ContactSpace& space);
  /// Bound of the contact's work that a space leaves out, and how much of it may be [J].
  [[nodiscard]] double missed_work(const ContactSpace& space) const;
  [[nodiscard]] double most_missed() const;
  void factorise(const Problem& problem, const LoadColumns& load);
  /// The static response where rigid motions are held at a mean of 0. False where K has none.
  bool hold_mean(const Problem& problem, Eigen::MatrixXcd& columns);
  [[nodiscard]] bool project(const Problem& problem, const LoadColumns& load);

  double base_frequency_ = 0.0;
  bool mean_is_free_ = false;
  Eigen::MatrixXcd lambda_;  // (H+1) x Nc
  Eigen::MatrixXcd load_;    // phi, (H+1) x Nf
  Eigen::MatrixXcd x_, q_;   // (H+1) x Nc, (H+1) x Nf
  Eigen::MatrixXcd free_;    // x without contact force, (H+1) x Nc
  Eigen::MatrixXcd free_q_;  // q without contact force, (H+1) x Nf
  double dissipation_ = 0.0;
};

/// The rigid motion R a, Nd [m], whose displacement W^T R a at the contacts is nearest to x, Nc [m]: what a
/// mean that ContactResponse leaves open is found to be; 0 where there is none. \throws std::runtime_error
/// where a part that no contact reaches leaves it open
Eigen::VectorXd rigid_offset(const Problem& problem, const Eigen::VectorXd& x);

/// M^-1 W, Nd x Nc: the jump of velocity that a unit impulse at each contact makes [1/kg].
/// \throws std::invalid_argument where M is singular
Eigen::MatrixXd velocity_jumps(const Problem& problem);

/// x under the load alone at count instants of the problem's period, count x Nc [m]; empty where the load
/// drives an undamped eigenfrequency, or a free structure at rest: no such motion exists.
/// \param space  as of ContactResponse
std::optional<Eigen::MatrixXd> contact_free_motion(const Problem& problem, int count,
                                                   const ContactSpace* space = nullptr);

}  // namespace signorini
