#pragma once
// Record by record.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// One row per record.
std::vector<Section> case_sections(const Evaluation& evaluation);

/// Records that did not converge or are not certified, with the reason.
std::vector<Section> remark_sections(const Evaluation& evaluation);

}  // namespace signorini
