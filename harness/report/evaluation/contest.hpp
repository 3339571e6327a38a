#pragma once
// Who may be compared with whom: methods that solve the same problem on the same scenes.

#include <string>
#include <vector>

#include "harness/report/evaluation/ladder.hpp"

namespace signorini {

/// Contestants that represent the laws of the same scenes. Each scene belongs to one contest.
struct Contest {
  std::vector<std::string> contestants = {};
  std::vector<std::string> scenes = {};
  std::vector<std::vector<const Ladder*>> ladders = {};  ///< [contestant][scene]
};

/// Contests of ladders, the largest first. A contestant that represents another law on a scene, or was not
/// run there, takes no part; one that does not apply does, and fails, unless it applies to no scene of the
/// contest. They point into `ladders`.
std::vector<Contest> contests_of(const std::vector<Ladder>& ladders);

/// What each contestant spends on each scene to reach an error, [contestant][scene]; infinite where it does
/// not get there. Zeros stay zeros.
using Costs = std::vector<std::vector<double>>;

/// Costs along one axis.
Costs costs_to_error(const Contest& contest, const CostAxis& axis, double error);

}  // namespace signorini
