#pragma once
// What curves leave out of an interval of their parameter.

#include <algorithm>
#include <vector>

namespace signorini {

/// Values of a parameter, low <= high.
struct ParameterRange {
  double low = 0.0;
  double high = 0.0;
};

/// Of the points of a branch, which has some.
template <class AnyBranch>
ParameterRange range_of(const AnyBranch& branch) {
  const auto value = [](const auto& point) { return point.parameter; };
  const auto [least, most] = std::ranges::minmax_element(branch.points, {}, value);
  return {least->parameter, most->parameter};
}

/// The parts of an interval that lie in none of the ranges, rising; those narrower than 1e-6 of it are none.
/// \param held      in any order, within the interval or not
/// \param from, to  ends of the interval, in either order
std::vector<ParameterRange> uncovered(std::vector<ParameterRange> held, double from, double to);

}  // namespace signorini
