#pragma once
// All that is known of one point of a curve, and what lies on the step between two of them.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "methods/orbit/family/survey.hpp"

namespace signorini {

/// Of a guard below which an orbit is not admissible: kAdmissible of the scales [-]
inline constexpr double kViolated = -1e-11;

/// A guard, or one maximum of a guard, with its derivative along the curve.
struct TrackedGuard {
  GuardMaximum guard;
  double rate = 0.0;  ///< d value / d arc length [-]
};

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
  SequencedOrbit orbit;  ///< there
};

/// Whether a guard is negative at a station.
bool violates(const Station& station);

/// The first zero of those guards that are negative at the end of a step of given length, located to
/// round-off; empty where one of them cannot be located. Precondition: there is one.
std::optional<GuardCrossing> first_crossing(ExtendedEquations& equations, const Station& begin, double length,
                                            const Station& end);

/// Bifurcations on a step, up to `inside`, in their order: signs of test functions that differ at its ends,
/// the zero located and `confirmed`. Where the branch ends within the step, at its end the curve may be its
/// own mirror, where a sign has changed twice: signs at `inside` count too.
std::vector<LocatedBifurcation> bifurcations(ExtendedEquations& equations, const Station& begin,
                                             double length, const Station& end, double inside);

}  // namespace signorini
