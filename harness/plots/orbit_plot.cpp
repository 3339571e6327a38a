#include "harness/plots/orbit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "harness/failure.hpp"
#include "harness/plots/drawn_stops.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr int kTics = 4;

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
  return fmt::format("{}: order {}, {}", orbit.fingerprint, orbit.order,
                     word.empty()          ? "stability unknown"
                     : word == "undefined" ? "stability undefined"
                                           : word);
}

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
      "parametric\nset size ratio -1\nset xrange [{0:.3g}:{1:.3g}]\nset yrange [{0:.3g}:{1:.3g}]\nset xtics "
      "{3:g}\nset ytics {3:g}\n{2}unset parametric\nset size noratio\nset xrange [*:*]\nset yrange "
      "[*:*]\nset xtics autofreq\nset ytics autofreq\n",
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
      "set title 'starts (hollow: unstable)'\nset xlabel 'orbit'\nset ylabel 'share of starts [%]'\nset "
      "xtics rotate by -35 ({}) font ',6'\nset xrange [-0.7:{}.7]\nset yrange [0:*]\n{}",
      names, orbits.size() - 1, canvas.panel());
}

}  // namespace

Figure orbit_plot(const Problem& problem, const std::vector<FoundOrbit>& orbits, Column column) {
  constexpr std::size_t kMostPortraits = 12;
  constexpr int kInstants = 2048;  // of a forcing period
  if (orbits.empty() || problem.contacts.empty())
    throw UsageError("plot = nothing to draw (there is no orbit)");
  const std::span<const FoundOrbit> shown = std::span(orbits).first(std::min(orbits.size(), kMostPortraits));
  const auto count = static_cast<int>(shown.size()) + 2;  // with multipliers and starts
  const int columns = std::min(count, is_narrow(column) ? 1 : 3), rows = (count + columns - 1) / columns;
  Figure figure{.name = "orbits", .width = width_in(column, 6.5 * columns), .height = 5.5 * rows};
  figure.script = panels(rows, columns) +
                  "set title font ',8'\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
                  "set xlabel 'x [m]' font ',8'\nset ylabel 'velocity [m/s]' font ',8'\n";
  Canvas canvas;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Samples motion = shown[i].certified.motion->sample(kInstants * shown[i].order);
    const Eigen::Index contact = liveliest(motion);
    canvas.draw(portrait_block(motion, contact), fmt::format("with lines {} lw 1.4", line_colour(i)),
                "x [m], velocity [m/s]");
    const std::span x(motion.x.col(contact).data(), static_cast<std::size_t>(motion.x.rows()));
    figure.script += fmt::format(
        "set title {} noenhanced\n{}{}unset arrow\n", gnuplot_string(title_of(shown[i])),
        abscissa_commands(x, stops_of(problem, static_cast<int>(contact)), kTics), canvas.panel());
  }
  figure.script += "set offsets 0, 0, 0, 0\n" + multiplier_panel(orbits, canvas) +
                   basin_panel(orbits, canvas) + "unset multiplot\n";
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
