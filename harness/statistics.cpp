#include "harness/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace signorini {

double median(std::vector<double> values) { return boost::math::statistics::median(values); }

double median_deviation(std::vector<double> values) {
  const double centre = median(values);
  for (double& value : values) value = std::abs(value - centre);
  return median(std::move(values));
}

Interval proportion(int count, int of) {
  constexpr double kQuantile = 1.959963984540054;  // of the normal distribution, 97.5 %
  const double n = of, share = count / n, squared = kQuantile * kQuantile;
  const double centre = (share + 0.5 * squared / n) / (1.0 + squared / n);
  const double half =
      kQuantile * std::sqrt(share * (1.0 - share) / n + 0.25 * squared / (n * n)) / (1.0 + squared / n);
  // Of none or all the ends are 0 or 1, but for rounding.
  return {.low = count == 0 ? 0.0 : centre - half, .high = count == of ? 1.0 : centre + half};
}

Estimate batch_mean(const std::vector<double>& values) {
  constexpr std::size_t kBatches = 20;
  constexpr double kUpper = 0.975;
  const std::size_t batches = std::min(values.size(), kBatches);
  std::vector<double> means;
  for (std::size_t b = 0; b < batches; ++b) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(b * values.size() / batches);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>((b + 1) * values.size() / batches);
    means.push_back(std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin));
  }
  const auto count = static_cast<double>(values.size());
  Estimate mean{.value = std::accumulate(values.begin(), values.end(), 0.0) / count};
  if (batches < 2 || !std::isfinite(mean.value)) return mean;
  const double deviation = std::sqrt(boost::math::statistics::sample_variance(means));
  const boost::math::students_t distribution(static_cast<double>(batches - 1));
  mean.error =
      boost::math::quantile(distribution, kUpper) * deviation / std::sqrt(static_cast<double>(batches));
  return mean;
}

}  // namespace signorini
