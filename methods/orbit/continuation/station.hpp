#pragma once
// All that is known of one point of a curve, and what lies on the step between two of them.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "methods/orbit/family/tracked_guards.hpp"

namespace signorini {

/// A point with its test functions.
struct Station {
  Eigen::VectorXd x, tangent;              ///< in CurveUnits
  BifurcationTests tests = {};             ///< there
  OrbitSurvey survey = {};                 ///< there
  std::vector<TrackedGuard> tracked = {};  ///< there, once `hidden_violation` has asked for them
  /// Of the equations there or next to it, if they are many: points near are then found by secants.
  std::shared_ptr<const CurveFactors> factors = {};
};

/// The orbit at which the equations are evaluated; range and factors as of bifurcation_tests.
Station station_at(ExtendedEquations& equations, const Eigen::VectorXd& tangent,
                   MultiplierRange range = MultiplierRange::all,
                   std::shared_ptr<const CurveFactors> factors = {});

/// Evaluates the equations at the point of a step from a station at a length, by secants where the station
/// has factors; false where the corrector fails.
bool move_along(ExtendedEquations& equations, const Station& begin, double length,
                const CorrectorLimits& limits = {});

/// The same as a point of a branch, in SI units. \param phases  of a forcing period at which it keeps its
/// motion
SolutionPoint solution_point(const ExtendedEquations& equations, const Station& station, int phases = 0);

/// The same of a phase resonance, with its damping ratio.
SolutionPoint resonance_point(const ExtendedEquations& equations, const Station& station);

/// The orbit at which the equations are evaluated, in SI units.
OrbitGuess orbit_at(const ExtendedEquations& equations);

/// A guard's zero on a step.
struct GuardCrossing {
  OrbitGuard guard;     ///< as it was at the end of the step, where it is negative
  double length = 0.0;  ///< of the step up to the zero
};

/// A bifurcation on a step.
struct LocatedBifurcation {
  double length = 0.0;  ///< of the step up to it
  SpecialPoint special;
  OrbitGuess special_orbit;     ///< as of an OrbitBranch
  SequencedOrbit orbit;         ///< there
  Eigen::VectorXd across = {};  ///< of a branch point: unit tangent of the other curve through it
};

/// Whether a guard is negative.
bool violates(const OrbitSurvey& survey);

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

/// The point of a step at a length with its guards, without its tests of bifurcations, at which `equations`
/// are left evaluated; empty where the corrector fails.
std::optional<Station> guards_at(ExtendedEquations& equations, const Station& begin, double length);

/// A point within a step.
struct StepPoint {
  double length = 0.0;
  Station station;
};

/// What the search between two points of a step has come to.
struct HiddenViolation {
  std::optional<StepPoint> found = {};  ///< a point at which the orbit is not admissible
  /// Somewhere it came to no end: too many guards come near zero, or an orbit cannot be had. A shorter step
  /// may tell.
  bool undecided = false;
};

/// A point of a step at which the orbit is not admissible, though it is so at both ends: where the cubic of a
/// guard, or of any of its maxima, less the bound of its error, becomes negative, the orbit there is solved
/// for and decides; on both sides of it the search goes on with the cubics of the parts, of 24 orbits at
/// most. A maximum that has no counterpart at the other end, being born or gone inside, is followed backwards
/// by its rate alone.
///
/// \param begin  of the step; its tracked guards are found if it has none yet, as are those of the end
/// \param end    station at `length`; `equations` are left evaluated anywhere on the step
HiddenViolation hidden_violation(ExtendedEquations& equations, Station& begin, double length, Station& end);

/// Where a step leaves the orbits of the scene.
struct StepEnd {
  std::optional<GuardCrossing> crossing = {};  ///< the first zero of a guard
  /// `end` violates a guard whose zero is not located, or the search between came to no end.
  bool undecided = false;
};

/// The first zero of a guard on a step, at its end or somewhere before. The step is then cut at a point where
/// the orbit is not admissible.
///
/// \param length, end  of the step; of the part, where it is cut. `equations` are left evaluated there
StepEnd cut_at_violation(ExtendedEquations& equations, Station& begin, double& length, Station& end);

}  // namespace signorini
