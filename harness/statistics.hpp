#pragma once
// Robust statistics of a sample.

#include <vector>

namespace signorini {

/// Middle value, the mean of the two middle ones for an even count. Requires at least one value.
double median(std::vector<double> values);

/// Median absolute deviation from the median. Requires at least one value.
double median_deviation(std::vector<double> values);

}  // namespace signorini
