#include "harness/plots/section_plot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "harness/failure.hpp"
#include "harness/plots/drawn_stops.hpp"
#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr int kInstants = 4096;
constexpr int kSectionTics = 5;

constexpr std::string_view kSectionFrame = R"(set multiplot layout 2,1
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror font ',8'
set title font ',8'
unset key
set offsets 0, 0, graph 0.05, graph 0.05
)";

}  // namespace

Figure section_plot(const Problem& problem, const LongMotion& motion, const Trajectory& waveform,
                    Column column) {
  if (problem.contacts.empty() || motion.section.empty())
    throw UsageError("plot = nothing to draw (no contact, or no period was measured)");
  const Samples samples = waveform.sample(kInstants);
  Eigen::Index contact = 0;
  (samples.x.colwise().maxCoeff() - samples.x.colwise().minCoeff()).maxCoeff(&contact);
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
  constexpr double kWidth = 14.0, kHeight = 14.0;  // [cm]
  Figure figure{.name = "motion", .width = width_in(column, kWidth), .height = kHeight};
  Canvas canvas;
  figure.script =
      std::string(kSectionFrame) +
      fmt::format(
          "set title {} noenhanced\nset xlabel 't [s]'\nset ylabel 'x [m]'\n",
          gnuplot_string(fmt::format("{}, contact {}: {}", problem.name, contact, name_of(motion.verdict))));
  for (const DrawnStop& stop : stops)
    canvas.plot(fmt::format("{:.10g} with lines {}", stop.place, kStopStyle));
  canvas.draw(line, "using 1:2 with lines lc rgb '#0072B2' lw 1.2", "t [s], x [m]");
  figure.script += canvas.panel();
  canvas.draw(points, "using 1:2 with points lc rgb '#0072B2' pt 7 ps 0.25",
              "x [m], velocity [m/s] at the beginning of each forcing period");
  figure.script += fmt::format(
      "set title 'stroboscopic section, {} forcing periods'\nset offsets graph 0.05, graph 0.05, graph 0.05, "
      "graph 0.05\nset xtics {:g}\nset xlabel 'x [m]'\nset ylabel 'velocity [m/s]'\n{}unset multiplot\n",
      motion.section.size(), tic_step(range_with(x, {}), kSectionTics), canvas.panel());
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
