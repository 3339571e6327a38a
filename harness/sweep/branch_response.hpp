#pragma once
// Branches of a response: by arc length of methods that follow curves of their own, of others by steps of the
// frequency.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/sweep/frequency_response.hpp"
#include "harness/table.hpp"
#include "methods/continuation/interval_gaps.hpp"
#include "methods/curve.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

/// A scene with the number at a place of its file left free between two values. \throws UsageError unless
/// these are finite and different, SceneError where they make no scene
ParametrisedScene over_place(const SceneSource& source, const std::string& place, double from, double to);

/// Longest period of motions looked for unless told otherwise [forcing periods]: six for exact orbits of a
/// small scene, of at most ten coordinates and with a periodic load, where one branch takes some
/// milliseconds; else that of CurveLimits.
int default_orders(const Problem& problem, const MethodChoice& method);

/// Whether a method follows curves of its own (Method::curve). \throws InvalidOption
bool has_curve(const MethodChoice& method);

/// \throws UsageError where a method has no curve of its own over the parameter of the scene, InvalidOption
void require_curve(const ParametrisedScene& scene, const MethodChoice& method);

/// The branches of a method by arc length; an interrupt ends them early. Empty where it has no curve of its
/// own. \throws UsageError as require_curve, InvalidOption
std::optional<BranchDiagram> branches_of(const ParametrisedScene& scene, const MethodChoice& method,
                                         const CurveLimits& limits);

/// All orbits that `find_all_orbits` finds at `values` values of the parameter spread over the interval, of
/// periods up to so many of the load: beginnings of branches that hang together with no other
/// (CurveLimits::begin_at). None without a periodic load. \param timeout  of all searches [s]
std::vector<KnownMotion> searched_motions(const ParametrisedScene& scene, int values, int max_order,
                                          double timeout);

/// Whether the branches are of free motions, whose points have an energy.
bool of_free_motions(const BranchDiagram& diagram);

/// "omega [rad/s]", "energy [J]", or the place of another number.
std::string parameter_title(const std::string& parameter);

/// Of a free motion the energy [J], or where that is the parameter the frequency [rad/s].
double other_than_parameter(const SolutionPoint& point);

/// The points of a branch where the parameter has one of several values; special points and ends stay.
Branch points_at(const Branch& branch, const std::vector<double>& values);

/// What one method makes of a response: its branches, or the points of its steps.
struct MethodResponse {
  std::string method;                               ///< label of the choice
  std::string other_law = {};                       ///< law_remark of the method on the scene: "e = 1"
  BranchDiagram diagram = {};                       ///< by arc length
  std::vector<SweepPoint> steps = {};               ///< of any other, or with natural steps
  int order = 1;                                    ///< of the motions that the steps look for
  std::string parameter = std::string(kFrequency);  ///< of the branches
  bool at_values = false;                           ///< the branches hold points_at values only
  std::string failure = {};                         ///< of a process that ended early
  std::optional<ParameterRange> asked = {};         ///< the interval
};

/// "aft-hbm", or with the law that the method represents where that is not the scene's, "aft-hbm, e = 1".
std::string name_with_law(const MethodResponse& response);

/// Parts of the interval asked for at which no branch by arc length has a motion (`uncovered`); neighbouring
/// points of a branch are taken to be joined. None without a branch, of branches that hold points at values
/// only, or of free motions where nothing was left undone: modes have their frequencies, and none between.
std::vector<ParameterRange> missing(const MethodResponse& response);

/// "exact-orbit: INCOMPLETE: no motion from 84.6 to 120: limit of 60 branches (--max-branches goes on)";
/// empty where nothing is missing
std::string incompleteness(const MethodResponse& response);

/// {"parameter", "branches", "unfinished", "notes", "incomplete"}, branches as to_json of a Branch has them.
/// Points of natural steps are {"omega", "order", "amplitude", "x_max", "status", "stable"}, those without an
/// answer with its reason as "message".
nlohmann::ordered_json to_json(const std::vector<MethodResponse>& responses);

/// One row per point and, unless points at values were asked for, special point, in the order of the
/// branches, with name_with_law as method; of free motions with energy and frequency. \param first  number of
/// the first branch
Table branch_table(const std::vector<MethodResponse>& responses, std::size_t first = 0);

}  // namespace signorini
