#pragma once
// Guards that are positive at both ends of a step and negative between them.

#include <optional>
#include <vector>

#include "methods/orbit/continuation/station.hpp"

namespace signorini {

/// A test function f of admissibility between two points of a curve, as a function of the length s in [0, h]
/// of the step, from values and derivatives at both ends:
///
///     f(s) = f_0 + p_0 z + c_2 z^2 + c_3 z^3 + e(z),   z = s / h,   |e| <= (|c_3| + |c_2| / 2) z^2 (1 -
///     z)^2.
///
/// The bound of e, which a constant fourth derivative would make an equation, assumes that the coefficient of
/// z^4 is not larger than that; an eighth of the depth of a parabola is granted in any case.
struct GuardCubic {
  double value = 0.0, last = 0.0;        ///< f_0, f_1 [-]
  double slope = 0.0, last_slope = 0.0;  ///< h f'_0, h f'_1 [-]
  /// z in (0, 1) where f may be least, with the least value that the bound of e allows there.
  struct Lowest {
    double at = 0.5;
    double bound = 0.0;
  };
  [[nodiscard]] Lowest lowest() const;
};

/// All guards of a station, each maximum by itself, with their derivatives along the curve: of a maximum that
/// at fixed phase, for to first order its phase does not count. One evaluation of the flow.
///
/// \param equations  left evaluated beside the station
std::vector<TrackedGuard> tracked_guards(ExtendedEquations& equations, const Station& station);

/// The point of a step at a length with its guards, without its tests of bifurcations, at which `equations`
/// are left evaluated; empty where the corrector fails.
std::optional<Station> guards_at(ExtendedEquations& equations, const Station& begin, double length);

/// A point within a step.
struct StepPoint {
  double length = 0.0;
  Station station;
};

/// A point of a step at which the orbit is not admissible, though it is so at both ends: where the cubic of a
/// guard, or of any of its maxima, less the bound of its error, becomes negative, the orbit there is solved
/// for and decides; on both sides of it the search goes on with the cubics of the parts. A maximum that has
/// no counterpart at the other end, being born or gone inside, is followed backwards by its rate alone. Empty
/// where there is none.
///
/// \param begin  of the step; its tracked guards are found if it has none yet, as are those of the end
/// \param end    station at `length`; `equations` are left evaluated anywhere on the step
std::optional<StepPoint> hidden_violation(ExtendedEquations& equations, Station& begin, double length,
                                          Station& end);

}  // namespace signorini
