#pragma once
// What a page shows of frequency responses: the exact branches of each scene under those of every method.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

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
