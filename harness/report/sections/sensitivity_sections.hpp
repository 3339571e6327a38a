#pragma once
// How answers depend on what should not matter: a constant, the samples at fixed harmonics, the repetition.

#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// Solved cases and errors at several values of one option, the others as stated.
std::vector<Section> sensitivity_sections(const Evaluation& evaluation);

/// Errors with one option false and true, over all scenes and scene by scene.
std::vector<Section> switch_sections(const Evaluation& evaluation);

/// How many repeated solves gave the same bits.
std::vector<Section> repeat_sections(const Evaluation& evaluation);

}  // namespace signorini
