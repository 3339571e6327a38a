#pragma once
// Statuses and times of every method over all scenes.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// How many cases of each method ended how, and the median time.
std::vector<Section> summary_sections(const Evaluation& evaluation);

/// Median error and time of each method at each resolution.
std::vector<Section> speed_sections(const Evaluation& evaluation);

}  // namespace signorini
