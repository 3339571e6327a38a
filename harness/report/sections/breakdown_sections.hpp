#pragma once
// Where each method breaks: families of scenes from easy to impossible.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The families, the severest level that each method solves, false convergence, and condition estimates.
/// Empty for a run without families.
std::vector<Section> breakdown_sections(const Evaluation& evaluation);

}  // namespace signorini
