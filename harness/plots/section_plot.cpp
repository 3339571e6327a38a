#include "harness/plots/section_plot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "harness/failure.hpp"
#include "harness/plots/drawn_stops.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

Figure section_plot(const Problem& problem, const LongMotion& motion, const Trajectory& waveform,
                    Column column) {
  if (problem.contacts.empty() || motion.section.empty())
    throw UsageError("plot = nothing to draw (no contact, or no period was measured)");
  constexpr int kInstants = 4096;
  const Samples samples = waveform.sample(kInstants);
  const Eigen::Index contact = liveliest(samples);
  const std::vector<DrawnStop> stops = stops_of(problem, static_cast<int>(contact));
  std::string line, points;
  for (Eigen::Index i = 0; i < samples.x.rows(); ++i)
    line += fmt::format("{:.8g} {:.8g}\n", waveform.period() * static_cast<double>(i) / kInstants,
                        samples.x(i, contact));
  const std::size_t place = 2 * static_cast<std::size_t>(contact);
  std::vector<double> x;
  for (const std::vector<double>& at : motion.section) {
    points += fmt::format("{:.8g} {:.8g}\n", at[place], at[place + 1]);
    x.push_back(at[place]);
  }
  Figure figure{.name = "motion", .width = width_in(column, 14.0), .height = 14.0};
  Canvas canvas;
  const std::string title = fmt::format("{}, contact {}: {}", problem.name, contact, name_of(motion.verdict));
  draw_stops(stops, canvas);
  canvas.draw(line, "using 1:2 with lines lc rgb '#0072B2' lw 1.2", "t [s], x [m]");
  figure.script =
      panels(2, 1) + fmt::format(
                         "set offsets 0, 0, graph 0.05, graph 0.05\nset title {} noenhanced font ',8'\n"
                         "set xlabel 't [s]'\nset ylabel 'x [m]'\n{}",
                         gnuplot_string(title), canvas.panel());
  canvas.draw(points, "using 1:2 with points lc rgb '#0072B2' pt 7 ps 0.25",
              "x [m], velocity [m/s] at the beginning of each forcing period");
  figure.script += fmt::format(
      "set title 'stroboscopic section, {} forcing periods'\nset offsets graph 0.05, graph 0.05, graph 0.05, "
      "graph 0.05\n{}set xlabel 'x [m]'\nset ylabel 'velocity [m/s]'\n{}unset multiplot\n",
      motion.section.size(), abscissa_commands(x, {}, 5), canvas.panel());
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
