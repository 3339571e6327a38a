#include "harness/report/evaluation/aggregates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

std::ptrdiff_t solved_count(std::span<const double> costs) {
  return std::ranges::count_if(costs, [](double cost) { return std::isfinite(cost); });
}

double shifted_geometric_mean(std::span<const double> costs, double shift, double failure) {
  double sum = 0.0;
  for (const double cost : costs) sum += std::log((std::isfinite(cost) ? cost : failure) + shift);
  return std::exp(sum / static_cast<double>(costs.size())) - shift;
}

double par2(std::span<const double> costs, double limit) {
  double sum = 0.0;
  for (const double cost : costs) sum += std::isfinite(cost) ? cost : 2.0 * limit;
  return sum / static_cast<double>(costs.size());
}

double PerformanceProfile::share(std::size_t configuration, double factor) const {
  const std::vector<double>& sorted = ratios[configuration];
  const auto within = std::upper_bound(sorted.begin(), sorted.end(), factor) - sorted.begin();
  return scenes == 0 ? 0.0 : static_cast<double>(within) / static_cast<double>(scenes);
}

PerformanceProfile performance_profile(const Costs& costs) {
  PerformanceProfile profile;
  profile.scenes = costs.empty() ? 0 : costs.front().size();
  profile.ratios.resize(costs.size());
  for (std::size_t s = 0; s < profile.scenes; ++s) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& row : costs) least = std::min(least, row[s]);
    for (std::size_t c = 0; c < costs.size(); ++c) {
      // Of two zeros the ratio is 1; a failure has none, nor has a cost beside one of zero.
      const double ratio = costs[c][s] == least ? 1.0 : costs[c][s] / least;
      if (std::isfinite(costs[c][s]) && std::isfinite(ratio)) profile.ratios[c].push_back(ratio);
    }
  }
  for (auto& ratios : profile.ratios) std::sort(ratios.begin(), ratios.end());
  return profile;
}

PerformanceProfile pairwise_profile(const Costs& costs, std::size_t first, std::size_t second) {
  return performance_profile({costs[first], costs[second]});
}

}  // namespace signorini
