#include "harness/report/sections/sections.hpp"

#include <algorithm>
#include <array>

namespace signorini {

namespace {

using SectionMaker = Sections (*)(const Evaluation&);

/// Sections that compare methods over scenes: of a single scene they say nothing that its rows do not.
constexpr std::array<SectionMaker, 7> kOverScenes{rival_sections, time_to_error_sections, interval_sections,
                                                  mean_sections,  distribution_sections,  pairwise_sections,
                                                  work_sections};

}  // namespace

Sections sections_of(const Evaluation& evaluation) {
  Sections sections;
  const bool one_scene = evaluation.scenes().size() < 2;
  for (const SectionMaker make :
       {summary_sections,      population_sections,    limit_sections,     outcome_sections,
        identity_sections,     ablation_sections,      breakdown_sections, sensitivity_sections,
        switch_sections,       rival_sections,         repeat_sections,    hand_over_sections,
        speed_sections,        time_to_error_sections, interval_sections,  mean_sections,
        distribution_sections, pairwise_sections,      work_sections,      scene_sections,
        other_law_sections,    case_sections,          remark_sections,    response_sections}) {
    if (evaluation.results().empty() && make != response_sections) continue;
    if (one_scene && std::ranges::find(kOverScenes, make) != kOverScenes.end()) continue;
    for (Section& section : make(evaluation)) {
      if (!section.table.rows.empty()) sections.push_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace signorini
