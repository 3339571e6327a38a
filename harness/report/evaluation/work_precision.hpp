#pragma once
// Work-precision curves: error against cost over the resolutions of a study.

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "harness/report/evaluation/resolution_study.hpp"

namespace signorini {

/// A cost by which runs are compared: seconds, or a count of work.
struct CostAxis {
  std::string_view name = {};  ///< "time", "pivots"
  std::optional<double> (*cost)(const CaseResult&) = nullptr;
};

/// Median time of set-up and solve [s].
const CostAxis& time_axis();

/// Pivots, iterations, evaluations of right-hand sides, factorisations, unknowns: free of noise. What an
/// iteration is differs between methods: counts compare resolutions of one method, or methods of one kind.
std::span<const CostAxis> work_axes();

/// Errors at which costs are compared [-].
inline constexpr std::array kErrorLevels{1e-1, 1e-2, 1e-3, 1e-6, 1e-9};

/// Infinite: not reached.
inline constexpr double kNeverReached = std::numeric_limits<double>::infinity();

/// A run on the curve of error against cost.
struct CurvePoint {
  double cost = 0.0;
  const ScoredRun* run = nullptr;
};

/// Those runs of a study that no other beats in both cost and error, by rising cost. Of runs whose errors
/// are bounds only the cheapest is there: below ten error bars nothing is better than anything.
std::vector<CurvePoint> pareto_curve(const ResolutionStudy& study, const CostAxis& axis);

/// The least cost among the runs whose error is at most `error`, and that run; infinite, and none, where no
/// run reached it. Nothing is inter- or extrapolated.
CurvePoint cost_to_error(const ResolutionStudy& study, const CostAxis& axis, double error);

/// The run by which an error is reached: the cheapest in time, of untimed ones the first; null where there is
/// none.
const ScoredRun* reaching_run(const ResolutionStudy& study, double error);

/// On how many scenes an error is reached, and how fast.
struct Reach {
  int scenes = 0;
  int stable = 0, unstable = 0;      ///< of these, by the motion of reaching_run; the rest is not determined
  std::vector<double> seconds = {};  ///< of each scene; infinite where it is not reached or was not timed

  /// Counts the scene of a study.
  void add(const ResolutionStudy& study, double error);
  /// Scenes whose motion is not known to be unstable: what recommendations count.
  [[nodiscard]] int lasting() const { return scenes - unstable; }
  /// Infinite where half of the scenes or more are not reached, or there is none [s].
  [[nodiscard]] double median_seconds() const;
};

}  // namespace signorini
