#include "harness/plots/drawn_stops.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/report/figures/canvas.hpp"

namespace signorini {

namespace {

bool are_opposite(const Contact& a, const Contact& b) {
  return std::ranges::equal(a.normal, b.normal, [](const auto& one, const auto& other) {
    return one.first == other.first && one.second == -other.second;
  });
}

}  // namespace

std::vector<DrawnStop> stops_of(const Problem& problem, int contact) {
  const Contact& own = problem.contacts[static_cast<std::size_t>(contact)];
  std::vector<DrawnStop> stops{{contact, own.gap}};
  for (int other = 0; other < problem.contact_count(); ++other) {
    const Contact& one = problem.contacts[static_cast<std::size_t>(other)];
    if (are_opposite(own, one)) stops.push_back({other, -one.gap});
  }
  return stops;
}

double range_with(const std::vector<double>& x, const std::vector<DrawnStop>& stops) {
  auto [least, largest] = std::ranges::minmax(x);
  for (const DrawnStop& stop : stops) {
    least = std::min(least, stop.place);
    largest = std::max(largest, stop.place);
  }
  return largest - least;
}

std::string wall_commands(const std::vector<DrawnStop>& stops) {
  std::string script;
  for (const DrawnStop& stop : stops)
    script += fmt::format("set arrow from {0:.10g}, graph 0 to {0:.10g}, graph 1 nohead {1}\n", stop.place,
                          kStopStyle);
  return script;
}

}  // namespace signorini
