#pragma once
// Rankings: which configurations are compared, by what costs, and many scenes in few numbers, failures
// included: means, and performance profiles [dolan2002].

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "harness/report/evaluation/resolution_study.hpp"

namespace signorini {

/// Default shift of geometric means [s].
inline constexpr double kMeanShift = 0.010;
/// Shifts between which an order must not change to be one [s].
inline constexpr std::array kMeanShifts{0.001, kMeanShift, 0.100};

/// Errors at which figures show performance profiles [-].
inline constexpr std::array kProfileErrors{1e-2, 1e-3, 1e-6};

/// Costs that are finite.
std::ptrdiff_t solved_count(std::span<const double> costs);

/// exp(mean log(cost + shift)) - shift, infinite costs taken as `failure`. The larger the shift, the less the
/// small costs matter: which shift must be said with the figure. Requires at least one cost.
double shifted_geometric_mean(std::span<const double> costs, double shift, double failure);

/// Penalised average: the mean, infinite costs taken as twice the limit. Requires at least one cost.
double par2(std::span<const double> costs, double limit);

/// Cost to reach an error, [configuration][scene]; infinite where it is not reached. Zeros stay zeros.
using Costs = std::vector<std::vector<double>>;

/// For each configuration the ratios of its cost to the least cost on the scene, over the scenes it solves.
struct PerformanceProfile {
  std::size_t scenes = 0;                        ///< solved or not
  std::vector<std::vector<double>> ratios = {};  ///< [configuration], finite, rising, >= 1

  /// Share of all scenes that a configuration solves at `factor` times the least cost or less. A scene that
  /// no method solves is one of all; a failure has no factor, however large.
  [[nodiscard]] double share(std::size_t configuration, double factor) const;
};

/// Joint profile of all rows. Where the least cost is zero, a cost above it has no finite ratio. With more
/// than two rows a profile ranks only the first: who is second changes with who else takes part
/// [gould2016].
PerformanceProfile performance_profile(const Costs& costs);

/// Costs of two configurations, scene by scene.
struct PairedCosts {
  /// Of the one over those of the other where one of them at least is finite; infinite where the other is
  /// not.
  std::vector<double> logarithms = {};

  PairedCosts(const std::vector<double>& one, const std::vector<double>& other);
  /// The median over the scenes that both solve; 1 where there is none.
  [[nodiscard]] double ratio() const;
  /// Whether each scene that one solves is solved by the other.
  [[nodiscard]] bool both_solve_all() const;
};

/// Whether two configurations differ in cost, a row for each, with a column for each: by 5 % at least or in
/// what they solve, and by more than chance would explain (signed_rank_probability of all pairs at 5 %
/// together, corrected_probabilities).
std::vector<std::vector<bool>> different_costs(const Costs& costs);

/// Configurations that represent the laws of the same scenes. Each scene belongs to one group.
struct RankingGroup {
  std::vector<std::string> configurations = {};
  std::vector<std::string> scenes = {};
  std::vector<std::vector<const ResolutionStudy*>> studies = {};  ///< [configuration][scene]
};

/// Groups of studies, the largest first. A configuration that represents another law on a scene, or was not
/// run there, is not ranked there. One that does not apply to a scene has not solved it; one that applies to
/// no scene of a group is left out of the group. The result points into `studies`.
/// \param is_ranked  whether a scene takes part
/// \param is_apart   whether it shares groups only with others that are
std::vector<RankingGroup> ranking_groups(
    const std::vector<ResolutionStudy>& studies,
    const std::function<bool(const std::string& scene)>& is_ranked,
    const std::function<bool(const std::string& scene)>& is_apart = [](const std::string&) { return false; });

/// Costs of all configurations of a group on all of its scenes.
Costs costs_to_error(const RankingGroup& group, const CostAxis& axis, double error);

/// Costs of all configurations of a group to each of its targets, a scene and one of kErrorLevels, each row
/// ascending.
Costs costs_to_targets(const RankingGroup& group, const CostAxis& axis);

}  // namespace signorini
