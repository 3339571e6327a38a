#pragma once
// Where a sequence of events changes other than by a grazing of rigid stops: the orbits beyond.

#include <optional>
#include <string>
#include <string_view>

#include "methods/orbit/continuation/switching.hpp"

namespace signorini {

/// What lies beyond the end of a nonlinear mode where it touches its stops.
inline constexpr std::string_view kLinearMode = "below it the linear mode; an end";

/// What lies beyond the end of a curve: where it goes on, or why it does not.
struct ChangeOfSequence {
  std::optional<CurveStart> start = {};
  std::string obstacle = {};  ///< one clause; empty where there is a start
};

/// The orbits on the other side of the end of a curve whose guard is no grazing of a rigid stop:
///
/// - events of two contacts exchanged: impacts that do not feel each other (G_ij = 0), or any event with one
///   of a spring or an undamped massless contact, where the vector field is continuous; of damped stops those
///   whose forces do not feel each other (C_ij = 0);
/// - at a stop that is not rigid a phase of contact, or a break of one, that begins with length 0 or has
/// ended
///   with it, at the impact of another contact too;
/// - at a rigid stop without restitution an impact after which the contact sticks, or does so no more.
///
/// Precondition: curve.guard.
ChangeOfSequence past_change(OrbitFamily& family, const TracedCurve& curve);

}  // namespace signorini
