#pragma once
// All branches that hang together with given orbits.

#include <functional>
#include <vector>

#include "methods/orbit/continuation/curve.hpp"

namespace signorini {

/// Orbits at a value of the parameter.
using OrbitsAt = std::function<std::vector<SequencedOrbit>(double parameter)>;

/// Follows the curves through given orbits both ways, and all that leave them, until every end is an end of
/// the interval or one where another branch ends or a reason stands:
///
/// - at a grazing of a rigid or damped stop the orbit without it, and the families of `grazing_families`;
/// - where impacts of uncoupled contacts coincide, the same orbit with their order exchanged;
/// - at a period doubling the doubled orbit.
///
/// Given orbits that do not hold the contact conditions, or lie on a branch that has been traced, are left
/// out. First what leads on into a part of the interval that no branch holds, then orbits of smaller periods.
/// Branches of more than two periods that are stable nowhere lead on to no others. What a limit leaves undone
/// is said in `unfinished`, what is met and not followed in `notes`: it is an end of its branch all the same.
/// \param more  asked for orbits in the widest part of the interval, above 1/500 of it, that no branch holds
///              and none leads into: at 16 values at most, and no more after four in vain
/// \param starts  of curves that are followed first, each one way
/// \param energies  as of trace_curve
OrbitDiagram trace_diagram(OrbitFamily& family, const std::vector<SequencedOrbit>& seeds,
                           const CurveLimits& limits, const OrbitsAt& more = {},
                           const std::vector<CurveStart>& starts = {},
                           const std::optional<ParameterRange>& energies = {});

}  // namespace signorini
