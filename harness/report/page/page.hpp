#pragma once
// A run as HTML: which method for which scenes, figures to look into, every table, and the record behind
// every number. A run is one page; one of very many cases is one page of what holds over all scenes, and
// pages of some scenes each.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Cases that a page holds at most, with their records: more are too long to load. The scenes of a run with
/// more are spread over several pages.
inline constexpr std::size_t kMostOfPage = 5000;

/// The page of a run; see whole_page.
/// \param title     of the run
/// \param manifest  as read_manifest gives it; null if there is none
/// \param links     HTML below the title, to other pages of the run
std::string html_page(const std::string& title, const nlohmann::ordered_json& manifest,
                      const Evaluation& evaluation, std::span<const Section> sections,
                      const std::string& links = {});

/// One of the pages that the scenes of a run are spread over.
struct PagePart {
  std::string file = {};                     ///< beside the page of the run: "pages/0001.html"
  std::span<const std::string> scenes = {};  ///< in the order of the evaluation
  std::span<const CaseResult> results = {};  ///< on these scenes
};

/// The parts of a run of at most `most` cases each; a scene is in one part, alone if it has more.
std::vector<PagePart> page_parts(const Evaluation& evaluation, std::size_t most = kMostOfPage);

/// The page of a run whose scenes are on other pages: verdict and tables over all scenes, links to the parts.
std::string overview_page(const std::string& title, const nlohmann::ordered_json& manifest,
                          const Evaluation& evaluation, std::span<const Section> sections,
                          std::span<const PagePart> parts);

/// The page of a part, an evaluation of its own: tables over all scenes are over those of the part.
std::string part_page(const std::string& title, const nlohmann::ordered_json& manifest,
                      const Evaluation& evaluation, std::span<const PagePart> parts, std::size_t number);

}  // namespace signorini
