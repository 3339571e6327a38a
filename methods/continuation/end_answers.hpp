#pragma once
// The answers of a method at both ends of an interval of frequencies: where its curves begin.

#include <memory>
#include <string>
#include <vector>

#include "methods/curve.hpp"

namespace signorini {

/// One of them.
struct EndAnswer {
  Problem problem;                                ///< the scene there
  std::shared_ptr<const Trajectory> motion = {};  ///< that solves it
};

/// From cold starts, at scene.from and scene.to. Where there is none `notes` says why.
/// \throws std::runtime_error if the structure cannot be factorised
std::vector<EndAnswer> end_answers(const ParametrisedScene& scene, const Method& method,
                                   const CurveLimits& limits, std::vector<std::string>& notes);

}  // namespace signorini
