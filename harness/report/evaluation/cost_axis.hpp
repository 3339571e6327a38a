#pragma once
// What a run costs: seconds, or counts of work.

#include <optional>
#include <span>
#include <string_view>

#include "harness/records/record.hpp"

namespace signorini {

/// A cost by which runs are compared.
struct CostAxis {
  std::string_view name = {};  ///< "time", "pivots"
  std::string_view unit = {};  ///< "s"; empty for counts
  std::optional<double> (*cost)(const Record&) = nullptr;
};

/// Median time of set-up and solve [s].
const CostAxis& time_axis();

/// Pivots, iterations, evaluations of right-hand sides, factorisations, unknowns: free of noise. What an
/// iteration is differs between methods: counts compare resolutions of one method, or methods of one kind.
std::span<const CostAxis> work_axes();

}  // namespace signorini
