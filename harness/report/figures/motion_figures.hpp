#pragma once
// Motions of one scene: signals over a period, and the phase portrait.

#include <string>
#include <vector>

#include "harness/report/document/figure.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// x, velocity, force and impulse over a period at one contact, and the phase portrait: the coarsest answer
/// of each configuration that has one, on the certified orbit. Empty where the records keep no motions.
std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene);

}  // namespace signorini
