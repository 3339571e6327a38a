#pragma once
// Which configurations are ranked against each other: those that solve the same problems on the same scenes.

#include <string>
#include <vector>

#include "harness/report/evaluation/aggregates.hpp"
#include "harness/report/evaluation/work_precision.hpp"

namespace signorini {

/// Configurations that represent the laws of the same scenes. Each scene belongs to one group.
struct RankingGroup {
  std::vector<std::string> configurations = {};
  std::vector<std::string> scenes = {};
  std::vector<std::vector<const ResolutionStudy*>> studies = {};  ///< [configuration][scene]
};

/// Groups of studies, the largest first. A configuration that represents another law on a scene, or was not
/// run there, is not ranked there. One that does not apply to a scene has not solved it; one that applies to
/// no scene of a group is left out of the group. The result points into `studies`.
std::vector<RankingGroup> ranking_groups(const std::vector<ResolutionStudy>& studies);

/// Costs of all configurations of a group on all of its scenes.
Costs costs_to_error(const RankingGroup& group, const CostAxis& axis, double error);

}  // namespace signorini
