#pragma once
// Time to error, scene by scene.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Configurations that represent the law of the scene.
std::vector<Section> scene_sections(const Evaluation& evaluation);

/// Configurations that represent another law than the scene.
std::vector<Section> other_law_sections(const Evaluation& evaluation);

}  // namespace signorini
