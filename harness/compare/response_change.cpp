#include "harness/compare/response_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace signorini {

namespace {

std::optional<ResponseChange> share_change(const char* name, double before, double after, double sign) {
  if (std::abs(after - before) <= kShareTolerance) return std::nullopt;
  return ResponseChange{
      .worse = sign * (after - before) < 0.0,
      .detail = fmt::format("{} {:.1f} % became {:.1f} %", name, 100.0 * before, 100.0 * after)};
}

/// Points of the exact response that were located; of that itself, which is compared with none, all.
std::ptrdiff_t located(const RecordedResponse& response) {
  if (!response.comparison) return std::ssize(response.located);
  return std::ranges::count_if(response.comparison->points,
                               [](const PointMatch& match) { return match.frequency.has_value(); });
}

}  // namespace

std::optional<ResponseChange> response_change(const RecordedResponse& before, const RecordedResponse& after) {
  if (before.comparison.has_value() != after.comparison.has_value())
    return ResponseChange{.worse = before.comparison.has_value(),
                          .detail = "it is compared with an exact response in one of the two only"};
  if (before.comparison) {
    const CurveComparison &was = *before.comparison, &is = *after.comparison;
    if (auto found = share_change("found", was.close.covered, is.close.covered, 1.0)) return found;
    if (auto found = share_change("false", was.wide.false_share, is.wide.false_share, -1.0)) return found;
  }
  const std::ptrdiff_t was = located(before), is = located(after);
  if (was == is) return std::nullopt;
  return ResponseChange{.worse = is < was,
                        .detail = fmt::format("special points located {} became {}", was, is)};
}

}  // namespace signorini
