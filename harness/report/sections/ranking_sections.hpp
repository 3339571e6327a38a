#pragma once
// Rankings: one section per group of configurations that are compared.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// How many scenes each configuration solves to each error, and the median time.
std::vector<Section> time_to_error_sections(const Evaluation& evaluation);

/// Shifted geometric means, PAR2 and shares of the joint performance profile, with its figure.
std::vector<Section> mean_sections(const Evaluation& evaluation);

/// Performance profiles of two configurations at a time.
std::vector<Section> pairwise_sections(const Evaluation& evaluation);

/// Counts of work to each error.
std::vector<Section> work_sections(const Evaluation& evaluation);

}  // namespace signorini
