#pragma once
// Branches of a frequency response: by arc length of exact orbits and of methods that follow their own curve,
// of others by steps of the frequency.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/sweep/frequency_response.hpp"
#include "harness/table.hpp"
#include "methods/orbit/continuation/diagram.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

/// The name of the method whose branches are those of exact orbits.
inline constexpr std::string_view kFollowedByArcLength = "exact-orbit";

/// The place of the parameter that is followed by default.
inline constexpr std::string_view kFrequency = "forcing.frequency";

/// Limits of a diagram.
struct BranchLimits {
  int max_order = 2;            ///< forcing periods per period of an orbit
  int max_branches = 60;        ///< in all
  int max_points = 2000;        ///< of one branch
  double timeout = 60.0;        ///< wall time of all [s]
  int phases = 0;               ///< of a forcing period at which points keep their motion; 0: they do not
  std::vector<double> at = {};  ///< values of the parameter at which every branch has points
  TakeBranch take = {};
  int searches = 0;  ///< values of the parameter at which exact_branches begins at all orbits of a search
  double largest_step = CurveOptions{}.largest_step;  ///< of exact orbits, in CurveUnits
};

/// Every branch of exact orbits that hangs together with the contact-free motions or the answers of
/// exact-orbit at both ends of an interval of a parameter, with its answers at up to eleven values inside, a
/// tenth of the time at most, at a rigid stop with an orbit of one impact at one of these, or, where searches
/// are asked for, with an orbit that `find_all_orbits` finds, in half of the time at most (`trace_diagram`).
/// \throws UsageError where continuation_obstacle names a reason
BranchDiagram exact_branches(const ParametrisedScene& scene, const BranchLimits& limits);

/// A scene with the number at a place of its file left free between two values. \throws UsageError unless
/// these are finite and different, SceneError where they make no scene
ParametrisedScene over_place(const SceneSource& source, const std::string& place, double from, double to);

/// The branches of a method on its own equations over the frequency (CurveMethod); empty where it has no
/// curve of its own. \throws UsageError where the method does not apply to the scene at an end of the
/// interval
std::optional<BranchDiagram> own_branches(const ParametrisedScene& scene, const MethodChoice& method,
                                          const BranchLimits& limits);

/// The branches of a method by arc length: exact_branches of exact-orbit, own_branches of any other.
std::optional<BranchDiagram> branches_of(const ParametrisedScene& scene, const MethodChoice& method,
                                         const BranchLimits& limits);

/// The points of a branch where the parameter has one of several values; special points and ends stay.
Branch points_at(const Branch& branch, const std::vector<double>& values);

/// What one method makes of a response: its branches, or the points of its steps.
struct MethodResponse {
  std::string method;                               ///< label of the choice
  BranchDiagram diagram = {};                       ///< by arc length
  std::vector<SweepPoint> steps = {};               ///< of any other, or with natural steps
  int order = 1;                                    ///< of the motions that the steps look for
  std::string parameter = std::string(kFrequency);  ///< of the branches
  bool at_values = false;                           ///< the branches hold points_at values only
};

/// {"parameter", "branches", "unfinished", "notes"}, branches as to_json of a Branch has them. Points of
/// natural steps are {"omega", "order", "amplitude", "x_max", "status", "stable"}.
nlohmann::ordered_json to_json(const std::vector<MethodResponse>& responses);

/// One row per point and, unless points at values were asked for, special point, in the order of the
/// branches. \param first  number of the first branch
Table branch_table(const std::vector<MethodResponse>& responses, std::size_t first = 0);

}  // namespace signorini
