#include "harness/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace signorini {

namespace {

constexpr double kUpper = 0.975;  // end of the interval in which a number is with 95 %

/// Twice the ranks of magnitudes, whole numbers where ties share theirs. Requires them to be sorted.
std::vector<long> doubled_ranks(const std::vector<double>& sorted) {
  std::vector<long> ranks(sorted.size());
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t end = first;
    while (end < sorted.size() && sorted[end] == sorted[first]) ++end;
    const auto shared = static_cast<long>(first + end + 1);
    std::fill(ranks.begin() + static_cast<std::ptrdiff_t>(first),
              ranks.begin() + static_cast<std::ptrdiff_t>(end), shared);
    first = end;
  }
  return ranks;
}

/// Probability that a sum of these, each taken or not with equal chance, is as far from its mean as `sum`.
double exact_tail(const std::vector<long>& ranks, long sum) {
  const long all = std::accumulate(ranks.begin(), ranks.end(), 0L);
  std::vector<double> chance(static_cast<std::size_t>(all) + 1, 0.0);  // of each sum
  chance[0] = 1.0;
  for (const long rank : ranks) {
    for (auto total = static_cast<long>(chance.size()) - 1; total >= 0; --total) {
      const double before = total >= rank ? chance[static_cast<std::size_t>(total - rank)] : 0.0;
      double& now = chance[static_cast<std::size_t>(total)];
      now = 0.5 * (now + before);
    }
  }
  double tail = 0.0;
  for (long total = 0; total <= all; ++total)
    if (std::abs(2 * total - all) >= std::abs(2 * sum - all)) tail += chance[static_cast<std::size_t>(total)];
  return std::min(1.0, tail);
}

/// The factor (1 + r) / (1 - r), at least 1, by which the variance of the mean is larger than that of
/// independent values, where neighbours of an autoregressive sequence have the correlation r. Their own mean
/// makes the correlation of n values smaller by 1 / n, which is added.
double persistence(const std::vector<double>& values) {
  constexpr double kMost = 0.9;  // what so few values tell: a factor of 19
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0, products = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    squares += (values[i] - mean) * (values[i] - mean);
    if (i > 0) products += (values[i] - mean) * (values[i - 1] - mean);
  }
  if (!(squares > 0.0)) return 1.0;
  const double r = std::clamp(products / squares + 1.0 / n, 0.0, kMost);
  return (1.0 + r) / (1.0 - r);
}

}  // namespace

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

Interval bootstrap_median(std::vector<double> values) {
  constexpr double kLower = 0.025;
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const auto middle = [&](std::size_t rank, double chance) {
    for (std::size_t k = 1; k < n; ++k) {
      const boost::math::binomial draws(static_cast<double>(n),
                                        static_cast<double>(k) / static_cast<double>(n));
      const double below =
          cdf(complement(draws, static_cast<double>(rank) - 1.0));  // of `rank` draws or more
      if (below >= chance) return values[k - 1];
    }
    return values.back();
  };
  return {.low = middle((n + 1) / 2, kLower), .high = middle(n / 2 + 1, kUpper)};
}

double signed_rank_probability(std::vector<double> differences) {
  constexpr std::size_t kMostExact = 200;
  std::erase(differences, 0.0);
  if (differences.empty()) return 1.0;
  std::ranges::sort(differences, {}, [](double d) { return std::abs(d); });
  std::vector<double> sizes(differences.size());
  std::ranges::transform(differences, sizes.begin(), [](double d) { return std::abs(d); });
  const std::vector<long> ranks = doubled_ranks(sizes);
  long sum = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (differences[i] > 0.0) sum += ranks[i];
    squares += static_cast<double>(ranks[i]) * static_cast<double>(ranks[i]);
  }
  if (ranks.size() <= kMostExact) return exact_tail(ranks, sum);
  const double mean = 0.5 * static_cast<double>(std::accumulate(ranks.begin(), ranks.end(), 0L));
  return std::erfc(std::abs(static_cast<double>(sum) - mean) / std::sqrt(0.5 * squares));
}

std::vector<double> corrected_probabilities(const std::vector<double>& probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return probabilities[i]; });
  std::vector<double> corrected(probabilities.size());
  double least = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    least = std::max(least, std::min(1.0, static_cast<double>(order.size() - k) * probabilities[order[k]]));
    corrected[order[k]] = least;
  }
  return corrected;
}

Estimate batch_mean(const std::vector<double>& values) {
  constexpr std::size_t kBatches = 20;
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
  const auto number = static_cast<double>(batches);
  const boost::math::students_t distribution(number - 1.0);
  mean.error = boost::math::quantile(distribution, kUpper) *
               std::sqrt(boost::math::statistics::sample_variance(means) * persistence(means) / number);
  return mean;
}

}  // namespace signorini
