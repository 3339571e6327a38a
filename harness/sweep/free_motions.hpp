#pragma once
// What is told of responses that are free motions, whose points have an energy.

#include <algorithm>
#include <string>

#include "methods/curve.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"

namespace signorini {

/// Whether the branches are of free motions.
inline bool of_free_motions(const BranchDiagram& diagram) {
  return std::ranges::any_of(diagram.branches, [](const Branch& branch) {
    return !branch.points.empty() && branch.points.front().energy.has_value();
  });
}

/// "omega [rad/s]", "energy [J]", or the place of another number.
inline std::string parameter_title(const std::string& parameter) {
  return parameter == kFrequency ? "omega [rad/s]" : parameter == kEnergy ? "energy [J]" : parameter;
}

/// Of a free motion the energy [J], or where that is the parameter the frequency [rad/s].
inline double other_than_parameter(const SolutionPoint& point) {
  return point.parameter == *point.energy ? point.frequency : *point.energy;
}

}  // namespace signorini
