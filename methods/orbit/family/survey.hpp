#pragma once
// What makes an orbit of a sequence a motion of the scene, as test functions along a curve, and its extremes.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

/// A guard below this is violated: the orbit is not admissible [-]
inline constexpr double kViolated = -kAdmissible;
/// A guard as near to zero as this is zero where a point of a curve was located by it [-]
inline constexpr double kGuardZero = 1e-8;
/// How near to zero a guard is where contacts touch or let go, and what a symmetry holds together parts [-]
inline constexpr double kTouches = 1e-9;

/// What a test function of admissibility measures.
enum class GuardKind {
  approach,   ///< of an event: x'_- of an impact or closing over V
  interval,   ///< of an event: theta_i - theta_{i-1}, around the period for the first, times its weight [rad]
  clearance,  ///< of a contact: least g_j - x_j over X at the local maxima of x_j while it is open
  corner,     ///< the same at an impact of another contact, where x_j turns back; of a closed contact
              ///< -lambda_j over its scale, where its rate jumps, or it does itself
  pressure,   ///< of a contact: least -lambda_j, over its scale, at the local maxima while it is closed
  landing,    ///< of a closing: -lambda_j just after it, over its scale
  release,    ///< of an impact without restitution: -x''_j after it, over omega V
  together,   ///< of an event that strikes several contacts: 1e-9 - the largest |g_j - x_j| of them over X
};

/// The weight of the interval before an event: 1e-3 where the event may come before the one that it follows
/// (OrbitEquations::may_overtake), as those that a symmetry holds together do to rounding; else 1.
double interval_weight(const ExtendedEquations& equations, Eigen::Index event);

/// A test function: positive where the orbit is admissible, smooth along a curve, zero where the sequence of
/// events changes.
struct OrbitGuard {
  GuardKind kind = GuardKind::approach;
  int index = 0;       ///< the event or the contact
  double value = 0.0;  ///< [-]
  double phase = 0.0;  ///< where, after the section [rad]

  [[nodiscard]] bool same(const OrbitGuard& other) const {
    return kind == other.kind && index == other.index;
  }
};

/// One of the maxima of which OrbitGuard has the largest: of clearance, corner or pressure.
struct GuardMaximum : OrbitGuard {  // as if it were the only one
  Eigen::Index part = 0;            ///< the arc that it lies on, after `part` events; of a corner its event
};

/// All test functions of an orbit, and its extremes.
struct OrbitSurvey {
  std::vector<OrbitGuard> guards;
  std::vector<GuardMaximum> maxima;  ///< all of them, part by part of each contact
  Eigen::VectorXd highest, lowest;   ///< of x_j over the period, exact, Nc [m]

  [[nodiscard]] const OrbitGuard* find(GuardKind kind, int index) const;
};

/// Of the orbit at which the equations are evaluated. Local maxima are those of `extremes`, to round-off.
OrbitSurvey survey(const ExtendedEquations& equations);

/// One of these test functions alone; empty where it does not exist.
std::optional<OrbitGuard> guard_of(const ExtendedEquations& equations, GuardKind kind, int index);

/// Its value [-].
std::optional<double> guard_value(const ExtendedEquations& equations, GuardKind kind, int index);

/// Those of `guards` that belong to events alone, for one phase is all that they take.
std::vector<OrbitGuard> event_guards(const ExtendedEquations& equations);

/// A maximum of a neighbouring orbit of the same sequence, at its phase (a corner: at its event), as the
/// equations have it where they are evaluated [-].
double value_at(const ExtendedEquations& equations, const GuardMaximum& maximum);

/// Whether a guard's zero where the equations are evaluated is the fading of an impact, or of a contact with
/// a damped stop, or a new one: the motion on either side is a grazing one.
bool is_grazing(const OrbitGuard& guard, const ExtendedEquations& equations);

/// What happens where a guard becomes zero, one clause: "contact 0 grazes its stop", ...
std::string describe(const OrbitGuard& guard, const SequencedOrbit& orbit, const ContactDynamics& dynamics);

}  // namespace signorini
