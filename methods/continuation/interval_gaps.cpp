#include "methods/continuation/interval_gaps.hpp"

#include <algorithm>

namespace signorini {

std::vector<ParameterRange> uncovered(std::vector<ParameterRange> held, double from, double to) {
  constexpr double kNarrow = 1e-6;  // of the interval
  const double low = std::min(from, to), high = std::max(from, to), narrow = kNarrow * (high - low);
  std::ranges::sort(held, {}, &ParameterRange::low);
  held.push_back({high, high});
  std::vector<ParameterRange> gaps;
  double reached = low;
  for (const ParameterRange& range : held) {
    if (range.low - reached > narrow) gaps.push_back({reached, std::min(range.low, high)});
    reached = std::max(reached, range.high);
    if (reached >= high) break;
  }
  return gaps;
}

}  // namespace signorini
