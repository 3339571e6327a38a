#pragma once
// Performance profiles [dolan2002] as a figure.

#include <cstddef>
#include <vector>

#include "harness/report/document/figure.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Joint performance profiles of the group at this place of Evaluation::groups, at three errors.
std::vector<Figure> profile_figures(const Evaluation& evaluation, std::size_t group);

}  // namespace signorini
