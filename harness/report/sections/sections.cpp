#include "harness/report/sections/sections.hpp"

#include <utility>

namespace signorini {

Sections sections_of(const Evaluation& evaluation) {
  Sections sections;
  const bool one_scene = evaluation.scenes().size() < 2;
  for (const auto make :
       {summary_sections, population_sections, limit_sections, outcome_sections, identity_sections,
        ablation_sections, breakdown_sections, sensitivity_sections, switch_sections, rival_sections,
        repeat_sections, hand_over_sections, speed_sections, ranking_sections, scene_sections,
        other_law_sections, case_sections, remark_sections, response_sections}) {
    if (evaluation.results().empty() && make != response_sections) continue;
    // Comparisons of methods over scenes: of a single scene they say nothing that its rows do not.
    if (one_scene && (make == rival_sections || make == ranking_sections)) continue;
    for (Section& section : make(evaluation)) {
      if (!section.table.rows.empty()) sections.push_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace signorini
