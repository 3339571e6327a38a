#pragma once
// A run as one HTML page that needs nothing but itself.

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Facts on the run in the header of a page: name and value, as in {"compiler", "GNU 12.2.0"}.
using RunFacts = std::vector<std::pair<std::string, std::string>>;

/// Facts from the text of a manifest.json; none if it is empty. \throws UsageError if it is no JSON object
RunFacts facts_of_manifest(const std::string& text);

/// The figures of one scene.
struct SceneFigures {
  std::string scene = {};
  std::vector<Figure> figures = {};
};

/// The page: overview, sections, scenes with their figures, and the record behind every number.
/// \param title  of the run
/// \param svgs   each figure as drawn, by name
std::string html_page(const std::string& title, const RunFacts& facts, const Evaluation& evaluation,
                      std::span<const Section> sections, std::span<const SceneFigures> scenes,
                      const std::map<std::string, std::string>& svgs);

// page.css and page.js.
extern const std::string_view kPageStyle, kPageScript;

}  // namespace signorini
