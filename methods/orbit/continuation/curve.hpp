#pragma once
// Follows the orbits of one sequence of events until the sequence changes, the interval ends, or no further.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/interval_gaps.hpp"
#include "methods/orbit/continuation/orbit_branch.hpp"
#include "methods/orbit/family/survey.hpp"

namespace signorini {

/// Why most branches end.
inline constexpr std::string_view kEndOfInterval = "end of the interval";

/// Of curves of orbits, which ask neither `far` nor `moved` and `small` [CurveUnits]
inline constexpr StepRules kOrbitSteps{.longest = 0.15, .shortest = 1e-7, .any_turn = 1e-4};

/// What branch besides the one that is followed goes through its start.
enum class LeftBranch {
  none,
  repetition,  ///< of orbits of half the period, passed twice
  crossing,    ///< of orbits of the same sequence
};

/// Where a curve begins and where it goes.
struct CurveStart {
  SequencedOrbit orbit;                  ///< on the curve
  Eigen::VectorXd tangent;               ///< the first step is taken along it
  std::string origin;                    ///< why there, one clause
  LeftBranch leaves = LeftBranch::none;  ///< that also goes through the start
  double first_step_share = 1.0;         ///< of the usual length [-]
  /// Two events that coincide there follow each other the other way round than on the branch that was left.
  bool exchanges = false;

  [[nodiscard]] int periods() const { return orbit.order; }  ///< of the load
};

/// A branch, and where it may be left.
struct TracedCurve {
  OrbitBranch branch;
  /// The start is not admissible beside itself, or the curve fell back on the branch it was to leave: one
  /// clause; `branch` is then to be dropped.
  std::string rejected = {};
  std::vector<SequencedOrbit> doublings = {};  ///< orbits with a multiplier -1
  /// Branch points, with the tangent of the other curve through them.
  std::vector<std::pair<SequencedOrbit, Eigen::VectorXd>> crossings = {};
  std::vector<std::string> notes = {};   ///< what the steps did not decide, one sentence each
  std::optional<OrbitGuard> guard = {};  ///< that became zero at the end
  bool meets_half_period = false;        ///< the end is next to the doubling of an orbit of half the period
  bool closes = false;                   ///< the end is the start
  SequencedOrbit last = {};              ///< the orbit at the end
};

/// Follows a curve by pseudo-arclength steps. A step is refused where the tangent turns by more than .35 rad,
/// and sized by the number of Newton steps and by that angle. After each, all guards (`survey`) and test
/// functions
/// (`bifurcation_tests`) are compared: of the guards that have become negative the first zero ends the curve,
/// located to round-off; test functions that have changed their sign before it are located likewise, and
/// where that fails, or one may have vanished twice (`may_hide_bifurcations`), the step is shortened. A guard
/// that is zero at the start is armed once it is positive; if it becomes negative first, the start is
/// rejected. The section moves to the middle of the longest time between two events when an event comes
/// within .2 rad of it.
/// \param energies  of free motions followed by their energy: the interval and limits.at are of it [J], and
///                  the parameter has no end
TracedCurve trace_curve(OrbitFamily& family, const CurveStart& start, const CurveLimits& limits,
                        const std::optional<ParameterRange>& energies = {});

}  // namespace signorini
