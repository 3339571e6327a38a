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

/// A value and the half-width of its interval of 95 % confidence.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

/// The mean of a stationary sequence whose neighbours depend on each other: that of at most 20 batches of
/// successive values, whose means are taken as independent, with the quantile of Student's distribution
/// [schmeiser1982]. The error of one value is 0. Requires at least one value.
Estimate batch_mean(const std::vector<double>& values);

}  // namespace signorini
