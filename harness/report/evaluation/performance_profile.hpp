#pragma once
// Performance profiles [dolan2002].

#include <cstddef>
#include <vector>

#include "harness/report/evaluation/ranking_group.hpp"

namespace signorini {

/// For each configuration the ratios of its cost to the least cost on the scene, over the scenes it solves.
struct PerformanceProfile {
  std::size_t scenes = 0;                        ///< solved or not
  std::vector<std::vector<double>> ratios = {};  ///< [configuration], finite, rising, >= 1

  /// Share of all scenes that a configuration solves at `factor` times the least cost or less. A scene that
  /// nobody solves is one of all; a failure has no factor, however large.
  [[nodiscard]] double share(std::size_t configuration, double factor) const;
};

/// Joint profile of all rows. Where the least cost is zero, a cost above it has no finite ratio.
PerformanceProfile performance_profile(const Costs& costs);

/// Profile of two configurations alone. With more than two, a joint profile ranks nobody but the first: who
/// is second changes with who else takes part [gould2016].
PerformanceProfile pairwise_profile(const Costs& costs, std::size_t first, std::size_t second);

}  // namespace signorini
