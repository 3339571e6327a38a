#include "harness/report/sections/sections.hpp"

#include <array>

#include "harness/report/sections/breakdown_sections.hpp"
#include "harness/report/sections/case_sections.hpp"
#include "harness/report/sections/ranking_sections.hpp"
#include "harness/report/sections/scene_sections.hpp"
#include "harness/report/sections/sensitivity_sections.hpp"
#include "harness/report/sections/summary_sections.hpp"

namespace signorini {

std::vector<Section> sections_of(const Evaluation& evaluation) {
  constexpr std::array<SectionMaker, 14> kMakers{
      summary_sections, breakdown_sections,     sensitivity_sections, switch_sections,   repeat_sections,
      speed_sections,   time_to_error_sections, mean_sections,        pairwise_sections, work_sections,
      scene_sections,   other_law_sections,     case_sections,        remark_sections};
  std::vector<Section> sections;
  for (const SectionMaker make : kMakers) {
    for (Section& section : make(evaluation)) {
      if (!section.table.rows.empty()) sections.push_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace signorini
