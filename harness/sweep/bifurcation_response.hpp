#pragma once
// Special points as curves over the frequency and a second number of the scene.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/sweep/branch_response.hpp"
#include "harness/table.hpp"

namespace signorini {

/// The second number of a scene, by its place, and its interval; curves begin at `from`.
struct SecondParameter {
  std::string place;
  double from = 0.0;
  double to = 1.0;
};

/// The kinds of special points that have a curve, by their names: "fold", "period-doubling",
/// "neimark-sacker", "grazing", "contact-change".
std::vector<std::string> followed_kinds();

/// Curves of the special points of a kind, over the frequency from `from` to `to` and a second number, from
/// each one that the method finds at its first value (CurveMethod::follow_bifurcations).
/// \param kind  one of followed_kinds. \throws UsageError where the method follows none of these or not this
/// scene, the interval is none or the place is that of the frequency; SceneError where an end is no scene;
/// InvalidOption
BifurcationCurves bifurcation_response(const SceneSource& source, double from, double to,
                                       const SecondParameter& second, const std::string& kind,
                                       const MethodChoice& method, const CurveLimits& limits);

/// {"parameter", "second", "curves": [{"kind", "sequence", "points": [{"omega", "second", "order",
/// "amplitude", "x_max", "impacts", "multipliers"}], "began", "ended"}], "unfinished"}.
/// \param second  its place
nlohmann::ordered_json to_json(const BifurcationCurves& response, const std::string& second);

/// One row per point, in the order of the curves.
/// \param second  its place
Table bifurcation_table(const BifurcationCurves& response, const std::string& second);

}  // namespace signorini
