#include "harness/plots/orbit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "harness/failure.hpp"
#include "harness/plots/drawn_stops.hpp"
#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::size_t kMostPortraits = 12;
constexpr int kDrawnInstants = 2048;
constexpr int kTics = 4;

/// The contact whose displacement has the largest range.
Eigen::Index liveliest(const Samples& motion) {
  Eigen::Index contact = 0;
  (motion.x.colwise().maxCoeff() - motion.x.colwise().minCoeff()).maxCoeff(&contact);
  return contact;
}

std::string portrait_block(const Samples& motion, Eigen::Index contact) {
  std::string lines;
  for (Eigen::Index i = 0; i <= motion.x.rows(); ++i) {
    const Eigen::Index row = i % motion.x.rows();
    lines += fmt::format("{:.8g} {:.8g}\n", motion.x(row, contact), motion.velocity(row, contact));
  }
  return lines;
}

std::string title_of(const FoundOrbit& orbit) {
  const std::string word = stability_word(orbit.certified.stable, orbit.certified.undefined);
  const std::string stability = word.empty()          ? "stability unknown"
                                : word == "undefined" ? "stability undefined"
                                                      : word;
  return fmt::format("{}: order {}, {}", orbit.fingerprint, orbit.order, stability);
}

constexpr int kSummaryPanels = 2;  // multipliers, starts

constexpr std::string_view kOrbitFrame = R"(set multiplot layout {},{}
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror font ',8'
set title font ',8'
unset key
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set xlabel 'x [m]' font ',8'
set ylabel 'velocity [m/s]' font ',8'
)";

/// The Floquet multipliers of all orbits in the complex plane, each in the colour of its portrait: an orbit
/// is unstable where one of them lies outside the circle.
std::string multiplier_panel(const std::vector<FoundOrbit>& orbits, Canvas& canvas) {
  double reach = 1.0;
  canvas.plot("[0:1] cos(2*pi*t), sin(2*pi*t) with lines lc rgb '#888888' lw 1");
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    std::string lines;
    for (const auto& [real, imaginary] : orbits[i].certified.floquet.value_or(FloquetMultipliers())) {
      lines += fmt::format("{:.8g} {:.8g}\n", real, imaginary);
      reach = std::max(reach, std::hypot(real, imaginary));
    }
    canvas.draw(lines, fmt::format("using 1:2 with points {} pt 7 ps 0.6", line_colour(i)),
                "multipliers, real and imaginary part");
  }
  return fmt::format(
      "set title 'Floquet multipliers'\nset xlabel 'real part'\nset ylabel 'imaginary part'\nset "
      "parametric\nset size ratio -1\nset "
      "xrange [{0:.3g}:{1:.3g}]\nset yrange [{0:.3g}:{1:.3g}]\nset xtics {3:g}\nset ytics {3:g}\n{2}unset "
      "parametric\nset size noratio\nset xrange [*:*]\nset yrange [*:*]\nset xtics autofreq\nset ytics "
      "autofreq\n",
      -1.1 * reach, 1.1 * reach, canvas.panel(), tic_step(2.2 * reach, kTics));
}

/// How many of the starts of the search ended at each orbit: an estimate of the sizes of their basins, for
/// stable ones; unstable ones are found by Newton's method.
std::string basin_panel(const std::vector<FoundOrbit>& orbits, Canvas& canvas) {
  int all = 0;
  for (const FoundOrbit& orbit : orbits) all += orbit.starts;
  std::string names;
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const double share = all > 0 ? 100.0 * orbits[i].starts / all : 0.0;
    const bool hollow = !orbits[i].certified.stable.value_or(false);
    canvas.draw(fmt::format("{} {:.4g}\n", i, share),
                fmt::format("using 1:2:(0.7) with boxes {} fs {}", line_colour(i),
                            hollow ? "empty" : "solid 0.6 border"),
                orbits[i].fingerprint);
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", gnuplot_string(orbits[i].fingerprint), i);
  }
  return fmt::format(
      "set title 'starts (hollow: unstable)'\nset xlabel 'orbit'\nset ylabel 'share of starts "
      "[%]'\nset "
      "xtics rotate by -35 ({}) font ',6'\nset xrange [-0.7:{}.7]\nset yrange [0:*]\n{}",
      names, orbits.size() - 1, canvas.panel());
}

}  // namespace

Figure orbit_plot(const Problem& problem, const std::vector<FoundOrbit>& orbits, Column column) {
  if (orbits.empty() || problem.contacts.empty())
    throw UsageError("plot = nothing to draw (there is no orbit)");
  const std::size_t count = std::min(orbits.size(), kMostPortraits);
  const auto panels = static_cast<int>(count) + kSummaryPanels;
  constexpr double kPanelWidth = 6.5, kPanelHeight = 5.5;  // [cm]
  const int columns = std::min(panels, is_narrow(column) ? 1 : 3), rows = (panels + columns - 1) / columns;
  Figure figure{
      .name = "orbits", .width = width_in(column, kPanelWidth * columns), .height = kPanelHeight * rows};
  figure.script = fmt::format(kOrbitFrame, rows, columns);
  Canvas canvas;
  for (std::size_t i = 0; i < count; ++i) {
    const Samples motion = orbits[i].certified.motion->sample(kDrawnInstants * orbits[i].order);
    const Eigen::Index contact = liveliest(motion);
    canvas.draw(portrait_block(motion, contact), fmt::format("with lines {} lw 1.4", line_colour(i)),
                "x [m], velocity [m/s]");
    const std::vector<DrawnStop> stops = stops_of(problem, static_cast<int>(contact));
    const Eigen::VectorXd x = motion.x.col(contact);
    figure.script += fmt::format(
        "set title {} noenhanced\nset xtics {:g}\n{}{}unset arrow\n", gnuplot_string(title_of(orbits[i])),
        tic_step(range_with({x.begin(), x.end()}, stops), kTics), wall_commands(stops), canvas.panel());
  }
  figure.script += "set offsets 0, 0, 0, 0\n" + multiplier_panel(orbits, canvas) +
                   basin_panel(orbits, canvas) + "unset multiplot\n";
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
