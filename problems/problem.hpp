#pragma once
// A contact scene as plain data: what every method is given and what the harness judges against.

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "problems/structure.hpp"

namespace signorini {

/// One term of the periodic load on one coordinate:
/// f_dof(t) += omega^p (cos * cos(harmonic * omega * t) + sin * sin(harmonic * omega * t)), p = omega_power.
/// Harmonic 0 is a constant load of size `cos`. An unbalance, mass times eccentricity, has p = 2.
struct ForceTerm {
  int dof = 0;          ///< coordinate that it acts on
  int harmonic = 1;     ///< h >= 0, of omega [-]
  double cos = 0.0;     ///< [N s^p]
  double sin = 0.0;     ///< [N s^p]
  int omega_power = 0;  ///< p, 0..2 [-]
};

/// One term of the prescribed motion of one coordinate:
/// r_dof(t) += cos * cos(harmonic * omega * t) + sin * sin(harmonic * omega * t).
struct FrameTerm {
  int dof = 0;       ///< coordinate that is carried along
  int harmonic = 1;  ///< h >= 1, of omega [-]
  double cos = 0.0;  ///< [m]
  double sin = 0.0;  ///< [m]
};

/// Newton's impact law, x'_+ = -e x'_-, at contact coordinates that carry mass.
struct Restitution {
  double e = 1.0;  ///< [-], 0 <= e <= 1
  /// Whether the coefficients are the same number.
  bool operator==(const Restitution&) const = default;
};

/// The stop is a spring: lambda = -stiffness * max(0, x - gap).
struct Spring {
  double stiffness = 0.0;  ///< k > 0 [N/m]
  /// Whether the stiffnesses are the same number.
  bool operator==(const Spring&) const = default;
};

/// The contact coordinate carries no mass: Signorini's conditions alone determine the motion.
struct Massless {
  /// True.
  bool operator==(const Massless&) const = default;
};

/// What happens when a contact closes.
using ContactLaw = std::variant<Massless, Restitution, Spring>;

/// One unilateral contact, x = sum of coefficient * u[dof] <= gap.
struct Contact {
  std::vector<std::pair<int, double>> normal;  ///< (dof, coefficient [-]), at least one nonzero
  double gap = 0.0;                            ///< [m], 0 or negative (preload) allowed
  ContactLaw law = Massless{};                 ///< its own: each contact has one
};

/// Springs as stops, one stiffness per contact.
struct Penalty {
  std::vector<double> stiffness;  ///< Nc, > 0 [N/m]
  /// Whether all stiffnesses are the same numbers.
  bool operator==(const Penalty&) const = default;
};

/// Contacts of different laws.
struct MixedLaws {
  std::vector<ContactLaw> laws;  ///< Nc
  /// Whether all laws are the same.
  bool operator==(const MixedLaws&) const = default;
};

/// The laws of the contacts of a scene as one, for those who tell it and for methods that know one law only.
/// std::monostate: the scene has no contact.
using Law = std::variant<std::monostate, Restitution, Penalty, Massless, MixedLaws>;

/// The laws of contacts as one: MixedLaws where they are of different kinds or restitutions.
Law common_law(const std::vector<ContactLaw>& laws);

/// A linear structure with unilateral contacts under periodic forcing,
///
///     M u'' + D u' + K u = f(t) + W lambda,   x = W^T u,
///     x_j <= g_j,  lambda_j <= 0,  lambda_j (x_j - g_j) = 0,
///
/// f of period 2 pi / omega. Sought are motions of period `subharmonic` * 2 pi / omega. Where stops move, u
/// and x are those of a frame that moves with them (problems/moving_frame.hpp), in which the stops rest: the
/// whole displacement of the structure is u + r(t).
struct Problem {
  std::string name;               ///< catalogue key, lower-kebab-case
  std::string title;              ///< one line for people
  std::string reference;          ///< where the scene comes from
  std::vector<std::string> tags;  ///< free words, used by filters
  std::string kind;               ///< "sdof", "chain", ...: how the matrices were built

  /// M, D and K. Copies of a problem share them; never null.
  std::shared_ptr<const Structure> structure = std::make_shared<const Structure>();

  double frequency = 1.0;         ///< omega > 0 [rad/s]
  int subharmonic = 1;            ///< order k >= 1 of the motion looked for [-]
  std::vector<ForceTerm> force;   ///< f(t) is the sum of them
  std::vector<FrameTerm> frame;   ///< r(t) is the sum of them; its loads are in `force`; empty: no stop moves
  std::vector<Contact> contacts;  ///< Nc of them, may be empty

  /// The laws of the contacts as one (common_law).
  [[nodiscard]] Law law() const;
  /// Gives all contacts this law, those of Penalty and MixedLaws in their order; std::monostate: none, as of
  /// contacts without mass. \throws std::invalid_argument for other numbers of them than contacts
  void set_law(const Law& law);

  /// M, Nd x Nd [kg].
  [[nodiscard]] const SparseMatrix& mass() const { return structure->mass; }
  /// D, Nd x Nd [N s/m].
  [[nodiscard]] const SparseMatrix& damping() const { return structure->damping; }
  /// K, Nd x Nd [N/m].
  [[nodiscard]] const SparseMatrix& stiffness() const { return structure->stiffness; }
  /// Calls edit(s) on a copy s of the structure and takes that for its own: whoever shared the old one keeps
  /// it. What D was assembled by is then no longer said.
  template <class Edit>
  void edit_structure(Edit&& edit) {
    Structure edited = *structure;
    edited.proportional.reset();
    std::forward<Edit>(edit)(edited);
    structure = std::make_shared<const Structure>(std::move(edited));
  }

  /// Nd, the number of coordinates.
  [[nodiscard]] int size() const { return static_cast<int>(mass().rows()); }
  /// Nc, the number of contacts.
  [[nodiscard]] int contact_count() const { return static_cast<int>(contacts.size()); }
  /// Period of the load, 2 pi / omega [s].
  [[nodiscard]] double forcing_period() const { return 2.0 * std::numbers::pi / frequency; }
  /// Period of the motion looked for, subharmonic * 2 pi / omega [s].
  [[nodiscard]] double period() const { return 2.0 * std::numbers::pi * subharmonic / frequency; }
  /// Base frequency of the motion looked for, omega / subharmonic [rad/s].
  [[nodiscard]] double base_frequency() const { return frequency / subharmonic; }
};

/// The same scene under a load of another frequency [rad/s], D and K at that speed where they follow it
/// (SpeedTerms). The one way to change the frequency of a problem whose matrices may follow it.
Problem at_frequency(Problem problem, double frequency);

/// Makes D and K of the structure, as they are, those at rest: omega times these matrices is added to them,
/// omega being the frequency of the load. \param gyroscopic, circulatory  Nd x Nd [N s^2/m] [N s/m]
void follow_speed(Structure& structure, const SparseMatrix& gyroscopic, const SparseMatrix& circulatory);

/// Whether D or K follow the frequency of the load: the structure is then another one at another frequency.
inline bool follows_speed(const Problem& problem) { return problem.structure->speed != nullptr; }

/// `problem` with motions of period `order` * 2 pi / omega sought.
Problem with_subharmonic(Problem problem, int order);

/// W, Nd x Nc: column j holds the normal of contact j, so that x = W^T u [-].
SparseMatrix contact_directions(const Problem& problem);
/// The directions of any list of contacts on a structure of `size` coordinates, size x contacts.size() [-].
SparseMatrix contact_directions(const std::vector<Contact>& contacts, int size);

/// Every coordinate with a part in some of these contacts, rising.
std::vector<int> contact_coordinates(const std::vector<Contact>& contacts);

/// Contacts that hang together by coordinates they share, rising: groups by their first contact.
std::vector<std::vector<int>> contact_groups(const std::vector<Contact>& contacts);

/// 1 / k of stops that are springs, 0 of the others, Nc [m/N].
Eigen::VectorXd stop_compliance(const Problem& problem);

/// Whether some contact takes impulses: it has a restitution.
bool has_impacts(const Problem& problem);
/// Whether some stop is a spring.
bool has_springs(const Problem& problem);

/// g, Nc [m].
Eigen::VectorXd contact_gaps(const Problem& problem);

/// Complex amplitude of one term at a frequency, omega^p (cos - i sin), without the sine at harmonic 0 [N].
std::complex<double> force_amplitude(const ForceTerm& term, double frequency);

/// Whether the amplitude of some term grows with the frequency: the load is then another one at another
/// frequency.
bool load_grows(const Problem& problem);

/// Static and harmonic load vectors at one harmonic of the FORCING frequency,
/// f(t) = sum_h Re(load_h e^{i h omega t}) with load_h = cos - i sin [N], Nd.
Eigen::VectorXcd load_harmonic(const Problem& problem, int harmonic);

/// d load_harmonic / d omega, Nd [N s].
Eigen::VectorXcd load_harmonic_rate(const Problem& problem, int harmonic);

/// Complex amplitudes of the prescribed motion of a coordinate, r_dof(t) = sum_h Re(r_h e^{i h omega t}),
/// h = 0..highest harmonic of the frame [m].
Eigen::VectorXcd frame_motion(const Problem& problem, int dof);

/// The same of the stop of a contact, w_j^T r(t) [m].
Eigen::VectorXcd stop_motion(const Problem& problem, int contact);

/// Highest harmonic of the forcing frequency present in the load; 0 when the load is constant.
int highest_load_harmonic(const Problem& problem);

/// highest_load_harmonic in harmonics of the motion sought, whose base frequency is omega / subharmonic: the
/// least number of harmonics with which a Fourier series over problem.period() represents the load.
int load_bandwidth(const Problem& problem);

/// How many periods `part` make up `period`, to 1e-6 of it; 0 where no whole number does, or more than a
/// million: of those every number is one to that.
int whole_periods(double period, double part);

/// f(t), Nd [N].
Eigen::VectorXd load_at(const Problem& problem, double time);

/// Inverse mass seen by the contacts, the Delassus matrix W^T M^{-1} W, Nc x Nc [1/kg].
/// Requires a nonsingular M (\throws std::invalid_argument otherwise).
Eigen::MatrixXd delassus_matrix(const Problem& problem);

/// Stiffness scale of each contact, w_j^T K w_j / |w_j|^4 [N/m], Nc: for one coordinate its own
/// stiffness. Where that vanishes, the inertia scale omega^2 w_j^T M w_j / |w_j|^4 stands in,
/// and where that vanishes too, omega w_j^T D w_j / |w_j|^4.
/// Options given "relative to the stiffness" (c, penalty) are multiples of this scale.
Eigen::VectorXd contact_stiffness_scale(const Problem& problem);

/// For each contact, whether M w_j != 0 beyond rounding, Nc.
std::vector<bool> contacts_with_mass(const Problem& problem);

}  // namespace signorini
