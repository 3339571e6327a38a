#pragma once
// Robust statistics of a sample.

#include <vector>

namespace signorini {

/// Middle value, the mean of the two middle ones for an even count. Requires at least one value.
double median(std::vector<double> values);

/// Median absolute deviation from the median. Requires at least one value.
double median_deviation(std::vector<double> values);

/// Ends of an interval of 95 % confidence.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// The share of a population from which `count` of `of` independent draws have a property: Wilson's score
/// interval [wilson1927]. Requires 0 <= count <= of, of >= 1.
Interval proportion(int count, int of);

/// The median of the population from which these are independent draws: the percentile interval of the
/// bootstrap [efron1979]. All its samples are counted, none is drawn: of n values the median of a sample is
/// at most the k-th where half of n draws or more are, each of which is with the probability k / n. Infinite
/// values are the largest. Requires at least one value.
Interval bootstrap_median(std::vector<double> values);

/// The probability, two-sided, of a sum of signed ranks [wilcoxon1945] as far from its mean as that of these
/// differences, were each of them as likely as its negative. Differences of 0 say nothing; equal magnitudes
/// share their ranks, infinite ones are the largest. Exact up to 200 differences, by the normal distribution
/// with the correction for ties beyond. 1 where no difference is left.
double signed_rank_probability(std::vector<double> differences);

/// Probabilities of several tests corrected for their number, so that the chance of any false one among them
/// is that of one test: Holm's step-down rule [holm1979]. In the order given.
std::vector<double> corrected_probabilities(const std::vector<double>& probabilities);

/// A value and the half-width of its interval of 95 % confidence.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

/// The mean of a stationary sequence whose neighbours depend on each other: that of at most 20 batches of
/// successive values, with the quantile of Student's distribution [schmeiser1982]. Where means of
/// neighbouring batches are correlated, as of a sequence that remembers longer than a batch, the error grows
/// by the factor of an autoregressive one [tafazzoli2011]. The error of one value is 0. Requires at least one
/// value.
Estimate batch_mean(const std::vector<double>& values);

}  // namespace signorini
