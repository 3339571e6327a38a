#include "harness/report/evaluation/aggregates.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

std::size_t solved_count(std::span<const double> costs) {
  return static_cast<std::size_t>(
      std::count_if(costs.begin(), costs.end(), [](double cost) { return std::isfinite(cost); }));
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

}  // namespace signorini
