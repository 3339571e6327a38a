#pragma once
// Work-precision diagrams: error against time on one scene.

#include <string>
#include <vector>

#include "harness/report/document/figure.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// One curve per configuration; hollow marks: below ten error bars. A second figure shows configurations that
/// represent another law, each against its own. Empty if no run has both error and time.
std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene);

}  // namespace signorini
