#pragma once
// A folder of responses as one HTML page: which method, every response to look into, every table, and the
// record behind every number.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "harness/responses/response_record.hpp"

namespace signorini {

/// What the figure of a scene draws; null without an exact response or where it has no branch.
///
///     {"from": 1.7, "to": 4.4,
///      "exact": {"record": 0, "branches": [{"w": [rad/s], "a": [m], "s": [1, 0, -1]}],
///                "points": [["fold", rad/s, m, order, 1]]},
///      "methods": [{"c": 3, "record": 4, "label": "hat-lcp", "steps": false, "branches": ..., "points":
///      ...}]}
///
/// `c` is the place of the method in labels_of, by which it has its colour; `record` that of the record; a
/// point ends with 0 where it is not on the exact response. Points of unknown amplitude are left out.
nlohmann::ordered_json response_data(std::span<const ResponseRecord> records, const std::string& scene);

/// The page of a folder of responses; see whole_page.
/// \param title     of the run
/// \param manifest  as read_manifest gives it; null if there is none
std::string response_page(const std::string& title, const nlohmann::ordered_json& manifest,
                          std::span<const ResponseRecord> records);

}  // namespace signorini
