#include "harness/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  const double above = *middle;
  const double below = *std::max_element(values.begin(), middle);
  // Equal ones first: two infinite values have no mean.
  return below == above ? above : 0.5 * (below + above);
}

double median_deviation(const std::vector<double>& values) {
  const double centre = median(values);
  std::vector<double> deviations;
  deviations.reserve(values.size());
  for (const double value : values) deviations.push_back(std::abs(value - centre));
  return median(std::move(deviations));
}

}  // namespace signorini
