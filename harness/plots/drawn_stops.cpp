#include "harness/plots/drawn_stops.hpp"

#include <fmt/format.h>

#include <algorithm>

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

Eigen::Index liveliest(const Samples& motion) {
  Eigen::Index contact = 0;
  (motion.x.colwise().maxCoeff() - motion.x.colwise().minCoeff()).maxCoeff(&contact);
  return contact;
}

std::string abscissa_commands(std::span<const double> x, const std::vector<DrawnStop>& stops, int most_tics) {
  auto [least, largest] = std::ranges::minmax(x);
  std::string walls;
  for (const DrawnStop& stop : stops) {
    least = std::min(least, stop.place);
    largest = std::max(largest, stop.place);
    walls += fmt::format("set arrow from {0:.10g}, graph 0 to {0:.10g}, graph 1 nohead {1}\n", stop.place,
                         kStopStyle);
  }
  return fmt::format("set xtics {:g}\n", tic_step(largest - least, most_tics)) + walls;
}

void draw_stops(const std::vector<DrawnStop>& stops, Canvas& canvas) {
  for (const DrawnStop& stop : stops)
    canvas.plot(fmt::format("{:.10g} with lines {}", stop.place, kStopStyle));
}

}  // namespace signorini
