#pragma once
// The parts of a page, each as HTML. All text of records in them is escaped.

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The sections of these kinds, in their order.
std::vector<const Section*> of_kinds(std::span<const Section> sections,
                                     std::initializer_list<SectionKind> kinds);

/// The rows on a scene of the section of this name, of these columns; of all but the first where none is
/// named, the scene's. Without a header where there is no such section.
Table rows_of_scene(std::span<const Section> sections, const std::string& id, const std::string& scene,
                    const std::vector<std::string>& columns = {});

/// The place in Evaluation::groups whose profiles a section shows.
std::optional<std::size_t> group_of(const Section& section);

/// Links to all parts of the page.
std::string navigation(const Evaluation& evaluation, std::span<const Section> sections);

/// The verdict of `report --format screen`, with all methods of each group.
std::string verdict_of(const Evaluation& evaluation);

/// Small figures of all scenes on the same axes.
std::string side_by_side(const Evaluation& evaluation);

/// A section with its words, its table, and performance profiles if it has any.
std::string section_of(const Section& section, const char* heading = "h2");

/// One scene: its law and orbit, its figures, and its rows of the sections of scenes.
/// \param data  of its figures: {"work": work_precision_data, "motion": motion_data, "schematic":
/// schematic_data}
std::string scene_of(const std::string& scene, const Evaluation& evaluation,
                     std::span<const Section> sections, const nlohmann::ordered_json& data);

// What a page shows of frequency responses: the exact branches of each scene under those of every method.

/// Whether a page is about motions: always but for a run of responses alone.
bool shows_motions(const Evaluation& evaluation);

/// Scenes with a response, in the order of the evaluation.
std::vector<std::string> scenes_followed(const Evaluation& evaluation);

/// What the figure of a scene draws; null without an exact response or where it has no branch.
///
///     {"from": 1.7, "to": 4.4,
///      "exact": {"record": 0, "branches": [{"w": [rad/s], "a": [m], "s": [1, 0, -1]}],
///                "points": [["fold", rad/s, m, order, 1]]},
///      "methods": [{"c": 3, "record": 4, "label": "hat-lcp", "steps": false, "branches": ..., "points":
///      ...}]}
///
/// `c` is the place of the method among the page's configurations, by which it has its colour: after those of
/// Evaluation::configurations, in the order of response_labels; `label` says its law where that is not the
/// scene's; `record` is the place of the record; a point ends with 0 where it is not on the exact response.
/// Points of unknown amplitude are left out.
nlohmann::ordered_json response_data(const Evaluation& evaluation, const std::string& scene);

/// The anchor of the response of a scene: "scene-NAME"; where the page has motions of it, "response-NAME".
std::string response_anchor(const Evaluation& evaluation, const std::string& scene);

/// The response of a scene: its figure, and its rows of the sections of responses.
/// \param data  as of response_data
std::string response_of(const std::string& scene, const Evaluation& evaluation,
                        std::span<const Section> sections, const nlohmann::ordered_json& data);

// What the figures of a page draw, as data for its charts (charts.js).

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
