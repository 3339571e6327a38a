#pragma once
// A contact scene as plain data: what every method is given and what the harness judges against.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace signorini {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// One term of the periodic load on one coordinate:
/// f_dof(t) += cos * cos(harmonic * omega * t) + sin * sin(harmonic * omega * t).
/// Harmonic 0 is a constant load of size `cos`.
struct ForceTerm {
  int dof = 0;       ///< coordinate that it acts on
  int harmonic = 1;  ///< h >= 0, of omega [-]
  double cos = 0.0;  ///< [N]
  double sin = 0.0;  ///< [N]
};

/// One unilateral contact, x = sum of coefficient * u[dof] <= gap.
struct Contact {
  std::vector<std::pair<int, double>> normal;  ///< (dof, coefficient [-]), at least one nonzero
  double gap = 0.0;                            ///< [m], 0 or negative (preload) allowed
};

/// Newton's impact law, x'_+ = -e x'_-, at contact coordinates that carry mass.
struct Restitution {
  double e = 1.0;  ///< [-], 0 <= e <= 1
};

/// The stop is a spring: lambda = -stiffness * max(0, x - gap), one stiffness per contact.
struct Penalty {
  std::vector<double> stiffness;  ///< Nc, > 0 [N/m]
};

/// No contact coordinate carries mass: Signorini's conditions alone determine the motion.
struct Massless {};

/// What happens when a contact closes. std::monostate: the scene has no contact.
using Law = std::variant<std::monostate, Restitution, Penalty, Massless>;

/// A linear structure with unilateral contacts under periodic forcing,
///
///     M u'' + D u' + K u = f(t) + W lambda,   x = W^T u,
///     x_j <= g_j,  lambda_j <= 0,  lambda_j (x_j - g_j) = 0,
///
/// f of period 2 pi / omega. Sought are motions of period `subharmonic` * 2 pi / omega.
struct Problem {
  std::string name;               ///< catalogue key, lower-kebab-case
  std::string title;              ///< one line for people
  std::string reference;          ///< where the scene comes from
  std::vector<std::string> tags;  ///< free words, used by filters
  std::string kind;               ///< "sdof", "chain", ...: how the matrices were built

  SparseMatrix mass;       ///< M, Nd x Nd, symmetric positive semi-definite [kg]
  SparseMatrix damping;    ///< D, Nd x Nd [N s/m]
  SparseMatrix stiffness;  ///< K, Nd x Nd, symmetric positive semi-definite [N/m]

  double frequency = 1.0;         ///< omega > 0 [rad/s]
  int subharmonic = 1;            ///< order k >= 1 of the motion looked for [-]
  std::vector<ForceTerm> force;   ///< f(t) is the sum of them
  std::vector<Contact> contacts;  ///< Nc of them, may be empty
  Law law;                        ///< monostate exactly where there is no contact

  /// Nd, the number of coordinates.
  [[nodiscard]] int size() const { return static_cast<int>(mass.rows()); }
  /// Nc, the number of contacts.
  [[nodiscard]] int contact_count() const { return static_cast<int>(contacts.size()); }
  /// Period of the motion looked for, subharmonic * 2 pi / omega [s].
  [[nodiscard]] double period() const { return 2.0 * std::numbers::pi * subharmonic / frequency; }
  /// Base frequency of the motion looked for, omega / subharmonic [rad/s].
  [[nodiscard]] double base_frequency() const { return frequency / subharmonic; }
};

/// A scene that cannot be computed: names the field, the value found and what is required.
/// `field` is the scene-file path of the culprit ("system.mass", "contact[1].gap").
class InvalidProblem : public std::invalid_argument {
 public:
  /// what() reads `field_path = value (required)`.
  InvalidProblem(std::string field_path, const std::string& value, const std::string& required)
      : std::invalid_argument(field_path + " = " + value + " (" + required + ")"),
        field(std::move(field_path)),
        found(value),
        requirement(required) {}

  std::string field;        ///< path of the offending field, as in the scene file
  std::string found;        ///< the value found, printed
  std::string requirement;  ///< what is required instead
};

/// Checks every invariant stated above; a Problem that passes is safe for every method.
/// Sizes agree; all numbers finite; M, K symmetric and positive semi-definite, M not zero;
/// frequency > 0; dofs in range; normals nonzero; 0 <= e <= 1 exactly where a contact carries mass.
/// Also: the symmetric part of D is positive semi-definite; M, D and K have no null vector in common;
/// subharmonic in 1..64, load harmonics in 0..10000, no sine at harmonic 0; unless the law is a penalty, all
/// contacts carry mass (on every coordinate of their normals) or none does. `name` and `kind` are not looked
/// at. \throws InvalidProblem on the first violation.
void validate(const Problem& problem);

/// W, Nd x Nc: column j holds the normal of contact j, so that x = W^T u [-].
SparseMatrix contact_directions(const Problem& problem);

/// g, Nc [m].
Eigen::VectorXd contact_gaps(const Problem& problem);

/// Static and harmonic load vectors at one harmonic of the FORCING frequency,
/// f(t) = sum_h Re(load_h e^{i h omega t}) with load_h = cos - i sin [N], Nd.
Eigen::VectorXcd load_harmonic(const Problem& problem, int harmonic);

/// Highest harmonic of the forcing frequency present in the load; 0 when the load is constant.
int highest_load_harmonic(const Problem& problem);

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

/// True where M w_j = 0 for every contact: no impact law is needed and none may be given.
bool contacts_are_massless(const Problem& problem);

}  // namespace signorini
