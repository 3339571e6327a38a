#include "harness/report/sections/sections.hpp"

namespace signorini {

Sections sections_of(const Evaluation& evaluation) {
  Sections sections;
  for (const auto make :
       {summary_sections, outcome_sections, identity_sections, ablation_sections, breakdown_sections,
        sensitivity_sections, switch_sections, repeat_sections, speed_sections, time_to_error_sections,
        mean_sections, pairwise_sections, work_sections, scene_sections, other_law_sections, case_sections,
        remark_sections}) {
    for (Section& section : make(evaluation)) {
      if (!section.table.rows.empty()) sections.push_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace signorini
