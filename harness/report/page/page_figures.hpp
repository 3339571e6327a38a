#pragma once
// What the figures of a page draw, as data for its charts (charts.js).

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Error against time on one scene, every run with both a mark that knows its record, and the best of them a
/// curve; methods of other laws apart. Null where no run has both.
///
///     {"floor": 1e-11, "own": [{"c": 3, "label": "hat-lcp", "marks": [[seconds, error, record, bounded,
///     "n=1"]],
///      "curve": [0, 2]}], "other": [...]}
///
/// `c` is the place of the configuration, by which all figures give it a colour; `record` that of the record
/// in the evaluation; `bounded` is 1 below ten error bars of the orbit; `curve` are places in `marks`.
nlohmann::ordered_json work_precision_data(const Evaluation& evaluation, const std::string& scene);

/// One period at the contact that takes most impulse: the certified orbit and the coarsest answer of each
/// configuration on it. Null where the records keep no motions.
///
///     {"contact": 0, "stop": [m], "orbit": {"t": [s], "x": [m], "v": [m/s], "f": [N], "p": [N s]},
///      "answers": [{"c": 3, "record": 17, "label": "hat-lcp[n=1]", "t": ..., "p": ...}]}
///
/// `stop` is that of stop_position, absent where the contact never closes. An answer of a motion that repeats
/// after several periods of the load may have its instants counted from another one of them; it is late by as
/// many as bring it closest to the orbit drawn.
nlohmann::ordered_json motion_data(const Evaluation& evaluation, const std::string& scene);

/// The picture of a scene's mechanical system as SVG, where the catalogue has the scene of the records, which
/// its digest tells, with at most kMostDrawn coordinates; null otherwise.
nlohmann::ordered_json schematic_data(const Evaluation& evaluation, const std::string& scene);

/// Coordinates beyond which reading a scene would take longer than the rest of the page.
inline constexpr int kMostDrawn = 1000;

/// Joint performance profiles [dolan2002] of the group at this place of Evaluation::groups, at each of
/// kProfileErrors.
///
///     [{"error": 0.01, "curves": [{"c": 3, "label": "hat-lcp", "steps": [[ratio of times, share of
///     scenes]]}]}]
nlohmann::ordered_json profile_data(const Evaluation& evaluation, std::size_t group);

}  // namespace signorini
