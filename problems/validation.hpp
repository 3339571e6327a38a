#pragma once
// The invariants of a Problem, checked once so that no method has to.

#include <stdexcept>
#include <string>
#include <utility>

#include "problems/problem.hpp"

namespace signorini {

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

/// Highest harmonic of a load, and of the motion of a stop.
inline constexpr int kMostLoadHarmonic = 10000;

/// Whether M, K and the symmetric part of D have to be factorised to know that they are what they must be.
/// Sums of finite-element matrices are, whatever the mesh: M and K are semi-definite, and a motion without
/// strain energy carries mass. Factorising them would cost more than everything else about a large scene.
/// Of a large structure from files it may not be judged: validate() says when.
enum class Definiteness { to_be_checked, by_construction, not_judged };

/// Checks every invariant that `Problem` states; a Problem that passes is safe for every method.
/// Sizes agree; all numbers finite; M and the symmetric parts of K and D semi-definite, M symmetric, not
/// zero; frequency > 0; dofs in range; normals nonzero; 0 <= e <= 1 exactly where a contact carries mass.
/// Also: M and the symmetric parts of D and K have no null vector in common; subharmonic in 1..64, load
/// harmonics in 0..10000, no sine at harmonic 0; under a restitution all coordinates of a normal carry mass.
/// `name` and `kind` are not looked at.
///
/// With Definiteness::by_construction it is taken for granted that M, K and the symmetric part of D are
/// semi-definite and have no null vector in common; of these, only diagonals are looked at.
/// The same holds of matrices that are to be checked but would take more than 5e10 operations to factorise
/// (a full matrix of 5,300 rows, a solid of some 64,000): there the first factorisation of a solve, whose
/// time and memory are limited, meets an indefinite matrix.
/// \throws InvalidProblem on the first violation
void validate(const Problem& problem, Definiteness definiteness = Definiteness::to_be_checked);

/// Checks the normal of a contact on a structure of `size` coordinates: each named once, numbers finite, one
/// of them not zero. \param field  in messages, "contact[1].normal" \throws InvalidProblem
void validate_normal(const std::vector<std::pair<int, double>>& normal, int size, const std::string& field);

}  // namespace signorini
