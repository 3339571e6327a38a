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

}  // namespace signorini
