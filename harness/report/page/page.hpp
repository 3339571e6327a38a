#pragma once
// A run as one HTML page: which method for which scenes, figures to look into, every table, and the record
// behind every number.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The page of a run, which needs nothing but itself. Records and the data of figures are in it in packed
/// form; only scripts of ours may run (a content security policy names them).
/// \param title     of the run
/// \param manifest  as read_manifest gives it; null if there is none
std::string html_page(const std::string& title, const nlohmann::ordered_json& manifest,
                      const Evaluation& evaluation, std::span<const Section> sections);

// The style sheet of this folder, its scripts in one, and the modules of D3 that they call.
extern const std::string_view kPageStyle, kPageScript, kChartLibrary;

}  // namespace signorini
