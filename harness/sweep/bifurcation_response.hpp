#pragma once
// Special points as curves over the frequency and a second number of the scene.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "harness/sweep/branch_response.hpp"
#include "harness/table.hpp"

namespace signorini {

/// The second number that is no place of the scene: the factor of all that varies in its load and in the
/// motion of its stops [-].
inline constexpr std::string_view kLoadFactor = "load-factor";

/// The second number of a scene, by its place or kLoadFactor, and its interval; curves begin at `from`.
struct SecondParameter {
  std::string place;
  double from = 0.0;
  double to = 1.0;
};

/// Curves of the special points of a kind, over the frequency from `from` to `to` and a second number, from
/// each one that the method finds at its first value (CurveMethod::follow_bifurcations).
/// \param kind  "fold", "period-doubling", "neimark-sacker", "phase-resonance", "grazing" or "contact-change"
/// \throws UsageError where the method follows none of these or not this
/// scene, the interval is none or the place is that of the frequency; SceneError where an end is no scene;
/// InvalidOption
BranchDiagram bifurcation_response(const SceneSource& source, double from, double to,
                                   const SecondParameter& second, const std::string& kind,
                                   const MethodChoice& method, const CurveLimits& limits);

/// The interval of the frequency of a backbone unless it is asked for: free_motion_band of the scene at rest.
/// \throws UsageError where there is none
ParameterRange backbone_band(const SceneSource& source);

/// {"parameter", "second", "curves": [{"kind", "sequence", "points": [{"second", ...}], "began", "ended"}],
/// "unfinished"}, the other keys of a point those of to_json(SolutionPoint); without those of stability where
/// the kind is a change of it.
/// \param kind    of bifurcation_response \param second  its place
nlohmann::ordered_json bifurcation_json(const BranchDiagram& curves, const std::string& kind,
                                        const std::string& second);

/// One row per point, in the order of the curves; of phase resonances with stability and damping ratio.
/// \param kind    of bifurcation_response \param second  its place
Table bifurcation_table(const BranchDiagram& curves, const std::string& kind, const std::string& second);

}  // namespace signorini
