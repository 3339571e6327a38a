#pragma once
// All that is known of one point of a curve, and what lies on the step between two of them.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "methods/orbit/family/tracked_guards.hpp"

namespace signorini {

/// Of a guard below which an orbit is not admissible: kAdmissible of the scales [-]
inline constexpr double kViolated = -1e-11;

/// A point with its test functions.
struct Station {
  Eigen::VectorXd x, tangent;              ///< in CurveUnits
  BifurcationTests tests = {};             ///< there
  OrbitSurvey survey = {};                 ///< there
  std::vector<TrackedGuard> tracked = {};  ///< there, once `hidden_violation` has asked for them
};

/// The orbit at which the equations are evaluated.
Station station_at(ExtendedEquations& equations, const Eigen::VectorXd& tangent);

/// The same as a point of a branch, in SI units. \param phases  of a forcing period at which it keeps its
/// motion
BranchPoint branch_point(const ExtendedEquations& equations, const Station& station, int phases = 0);

/// A guard's zero on a step.
struct GuardCrossing {
  OrbitGuard guard;     ///< as it was at the end of the step, where it is negative
  double length = 0.0;  ///< of the step up to the zero
};

/// A bifurcation on a step.
struct LocatedBifurcation {
  double length = 0.0;  ///< of the step up to it
  SpecialPoint special;
  SequencedOrbit orbit;         ///< there
  Eigen::VectorXd across = {};  ///< of a branch point: unit tangent of the other curve through it
};

/// Whether a guard is negative at a station.
bool violates(const Station& station);

/// The first zero of those guards that are negative at the end of a step of given length, located to
/// round-off; empty where one of them cannot be located. Precondition: there is one.
std::optional<GuardCrossing> first_crossing(ExtendedEquations& equations, const Station& begin, double length,
                                            const Station& end);

/// The bifurcations on a step.
struct StepBifurcations {
  std::vector<LocatedBifurcation> found = {};  ///< in their order
  bool undecided = false;  ///< a sign changed whose zero was not located: a shorter step may tell
};

/// Bifurcations on a step, up to `inside`: signs of test functions that differ at its ends, the zero located
/// and `confirmed`, that of a branch point by `solve_branch_point`. Where the branch ends within the step, at
/// its end the curve may be its own mirror, where a sign has changed twice: signs at `inside` count too.
StepBifurcations bifurcations(ExtendedEquations& equations, const Station& begin, double length,
                              const Station& end, double inside);

/// The tests of bifurcations at a point, and the length of the step from there to the next.
struct TestsBefore {
  BifurcationTests tests = {};
  double length = 0.0;
};

/// Whether a test function may have vanished twice on a step at whose ends it has one sign: its parabola
/// through both and the point before, values of one magnitude, comes within a tenth of the smaller of its
/// values there of zero, or the numbers of real multipliers above 1, of those below -1, or of pairs outside
/// the circle differ by two or more. Multipliers and tests that are not known say nothing.
///
/// \param before  the step before; empty at the first point of a curve, where the multipliers alone are asked
bool may_hide_bifurcations(const std::optional<TestsBefore>& before, const BifurcationTests& begin,
                           double length, const BifurcationTests& end);

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

/// Where a step leaves the orbits of the scene, at its end or somewhere before: the first zero of a guard.
/// The step is then cut at a point where the orbit is not admissible.
///
/// \param length, end  of the step; of the part, where it is cut. `equations` are left evaluated there
/// \return empty where it does not, and, though `end` violates a guard, where its zero cannot be located
std::optional<GuardCrossing> cut_at_violation(ExtendedEquations& equations, Station& begin, double& length,
                                              Station& end);

}  // namespace signorini
