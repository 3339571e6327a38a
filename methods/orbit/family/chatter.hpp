#pragma once
// Complete chatter along a curve: infinitely many impacts that end in contact, of which so many are unknowns
// that the others displace nothing.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/orbit/family/extended_equations.hpp"
#include "methods/orbit/family/survey.hpp"

namespace signorini {

/// Why a curve ends where chatter stops completing: infinitely many impacts graze there, with no finite
/// sequence beyond.
inline constexpr const char* kChatterLimit = "chatter limit";

/// A closing of a rigid stop of restitution e > 0, which ends a chatter. The impacts that would follow the
/// speed v at which it closes form a geometric sequence of ratio e under the acceleration a that presses the
/// contact on; it is carried to its limit at once, with an error of
///
///     e v^2 / (2 a (1 - e))
///
/// in the displacement, while the sequence would last 2 e v / (a (1 - e)).
struct ChatterEnd {
  Eigen::Index closing = 0;   ///< the event
  double speed = 0.0;         ///< v [m/s]
  double acceleration = 0.0;  ///< a [m/s^2]
  double left_out = 0.0;      ///< the error over X; infinite unless a > 0 and e < 1 [-]
  double rest = 0.0;          ///< how long the sequence lasts over how long the contact is closed [-]
};

/// Those of the orbit at which the equations are evaluated, in the order of its events; empty where e = 0 or
/// the stops are springs.
std::vector<ChatterEnd> chatter_ends(const ExtendedEquations& equations);

/// An orbit with other impacts resolved, or why it cannot be had; neither where it may stay as it is.
struct ResolvedChatter {
  std::optional<SequencedOrbit> orbit = {};
  std::string obstacle = {};  ///< one clause, kChatterLimit where the rest of a sequence would last longer
                              ///< than half the contact
};

/// The same orbit, to what is left out, with impacts added before each closing until kAdmissible X is kept,
/// or taken away while it is kept by far; solved at its value of the parameter.
///
/// \param equations  evaluated at the orbit
ResolvedChatter resolve_chatter(const ExtendedEquations& equations);

/// Whether an orbit leaves out more than a polish accepts: the step to it was too long for its impacts.
bool leaves_out_too_much(const ExtendedEquations& equations);

/// Whether a guard that is zero ends a chatter: the contact rests no more after its impacts.
bool ends_chatter(const ExtendedEquations& equations, const OrbitGuard& guard);

}  // namespace signorini
