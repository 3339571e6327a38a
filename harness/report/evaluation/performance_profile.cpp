#include "harness/report/evaluation/performance_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

namespace {

double least_cost(const Costs& costs, std::size_t scene) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& row : costs) least = std::min(least, row[scene]);
  return least;
}

double ratio(double cost, double least) {
  if (!std::isfinite(cost)) return cost;
  return cost == least ? 1.0 : cost / least;
}

}  // namespace

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
    const double least = least_cost(costs, s);
    for (std::size_t c = 0; c < costs.size(); ++c) {
      const double factor = ratio(costs[c][s], least);
      if (std::isfinite(factor)) profile.ratios[c].push_back(factor);
    }
  }
  for (auto& ratios : profile.ratios) std::sort(ratios.begin(), ratios.end());
  return profile;
}

PerformanceProfile pairwise_profile(const Costs& costs, std::size_t first, std::size_t second) {
  return performance_profile({costs[first], costs[second]});
}

}  // namespace signorini
