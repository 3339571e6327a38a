#pragma once
// A run as one HTML page: which method for which scenes, figures to look into, every table, and the record
// behind every number.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The page of a run; see whole_page.
/// \param title     of the run
/// \param manifest  as read_manifest gives it; null if there is none
std::string html_page(const std::string& title, const nlohmann::ordered_json& manifest,
                      const Evaluation& evaluation, std::span<const Section> sections);

}  // namespace signorini
