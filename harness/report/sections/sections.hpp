#pragma once
// The sections of a report, in their order.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Makes sections from a run; none where the run has nothing to show.
using SectionMaker = std::vector<Section> (*)(const Evaluation& evaluation);

/// Every section of a report that has rows. A new table is a SectionMaker and one line in this function.
std::vector<Section> sections_of(const Evaluation& evaluation);

}  // namespace signorini
