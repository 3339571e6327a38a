#pragma once
// Two bifurcations on one step, which leave the sign of their test function at its ends.

#include <optional>

#include "methods/orbit/continuation/bifurcations.hpp"

namespace signorini {

/// The tests of bifurcations at a point, and the length of the step from there to the next.
struct TestsBefore {
  BifurcationTests tests = {};
  double length = 0.0;
};

/// Whether a test function may have vanished twice on a step at whose ends it has one sign. Its parabola
/// through both and the point before comes within a tenth of the smaller of its values there of zero, asked
/// of
///
/// - log |mu| of the real multipliers above 0, of those below 0 and of the pairs, each sort by rank, where
///   each of the three points has as many above .01: these have no decades to fade by;
/// - the test functions, where their values are of one magnitude: of a motion without loss, whose pairs stay
///   on the circle up to their bifurcation, and where a multiplier is beyond all bounds;
///
/// or more multipliers have crossed the circle than the signs of the test functions tell of. Multipliers and
/// tests that are not known say nothing.
///
/// \param before  the step before; empty at the first point of a curve, where those that crossed alone are
/// asked
bool may_hide_bifurcations(const std::optional<TestsBefore>& before, const BifurcationTests& begin,
                           double length, const BifurcationTests& end);

}  // namespace signorini
