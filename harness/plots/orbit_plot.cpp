#include "harness/plots/orbit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::size_t kMostPortraits = 12;
constexpr int kInstants = 2048;

/// The contact whose displacement has the largest range.
Eigen::Index liveliest(const Samples& motion) {
  Eigen::Index contact = 0;
  (motion.x.colwise().maxCoeff() - motion.x.colwise().minCoeff()).maxCoeff(&contact);
  return contact;
}

std::string portrait_block(const Samples& motion, Eigen::Index contact) {
  std::string lines = "# x [m], velocity [m/s]\n";
  for (Eigen::Index i = 0; i <= motion.x.rows(); ++i) {
    const Eigen::Index row = i % motion.x.rows();
    lines += fmt::format("{:.8g} {:.8g}\n", motion.x(row, contact), motion.velocity(row, contact));
  }
  return lines + "\n\n";
}

std::string title_of(const FoundOrbit& orbit) {
  const auto& stable = orbit.certified.stable;
  const char* stability = !stable ? "stability unknown" : *stable ? "stable" : "unstable";
  return fmt::format("{}: order {}, {}", orbit.fingerprint, orbit.order, stability);
}

}  // namespace

Figure orbit_plot(const Problem& problem, const std::vector<FoundOrbit>& orbits) {
  if (orbits.empty() || problem.contacts.empty())
    throw UsageError("plot = nothing to draw (there is no orbit)");
  const std::size_t count = std::min(orbits.size(), kMostPortraits);
  const auto columns = static_cast<int>(std::min<std::size_t>(count, 3));
  const int rows = (static_cast<int>(count) + columns - 1) / columns;
  Figure figure{.name = "orbits", .width = 6.5 * columns, .height = 5.5 * rows};
  figure.script = fmt::format(
      "set multiplot layout {},{}\nset grid back lc rgb '#dddddd' lw 0.5\nset border 3\nset tics nomirror "
      "font "
      "',8'\nset title font ',8'\nunset key\nset xlabel 'x [m]' font ',8'\nset ylabel 'velocity [m/s]' font "
      "',8'\n",
      rows, columns);
  for (std::size_t i = 0; i < count; ++i) {
    const Samples motion = orbits[i].certified.motion->sample(kInstants * orbits[i].order);
    const Eigen::Index contact = liveliest(motion);
    figure.data += portrait_block(motion, contact);
    figure.script += fmt::format(
        "set title {} noenhanced\nset arrow 1 from {:.10g}, graph 0 to {:.10g}, graph 1 nohead lc rgb "
        "'#D55E00' dt "
        "(6,3)\nplot data index {} with lines lc rgb '#0072B2' lw 1.4\n",
        gnuplot_string(title_of(orbits[i])), problem.contacts[static_cast<std::size_t>(contact)].gap,
        problem.contacts[static_cast<std::size_t>(contact)].gap, i);
  }
  figure.script += "unset multiplot\n";
  return figure;
}

}  // namespace signorini
