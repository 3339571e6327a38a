#include "harness/statistics.hpp"

#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <utility>

namespace signorini {

double median(std::vector<double> values) { return boost::math::statistics::median(values); }

double median_deviation(std::vector<double> values) {
  const double centre = median(values);
  for (double& value : values) value = std::abs(value - centre);
  return median(std::move(values));
}

}  // namespace signorini
