#include "harness/plots/history_plot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::string_view kFrame = R"(set multiplot layout 3,1
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror font ',8'
set lmargin 10
unset key
)";

constexpr std::string_view kCurve = "using 1:2 with linespoints lc rgb '#0072B2' pt 7 ps 0.5 lw 1.2";

/// "2026-11-29 0123456": date and the beginning of the commit of a run.
std::string label_of(const HistoryPoint& point) {
  constexpr std::size_t kDay = 10, kDigits = 7;
  return point.date.substr(0, kDay) + " " + point.commit.substr(0, kDigits);
}

std::string tics(const History& history, bool named) {
  std::string list;
  for (std::size_t i = 0; i < history.points.size(); ++i)
    list += fmt::format("{}{} {}", i == 0 ? "" : ", ",
                        gnuplot_string(named ? label_of(history.points[i]) : ""), i);
  return fmt::format("set xtics ({}) rotate by -30 noenhanced\n", list);
}

/// A line per run that has the measure.
template <class Measured>
std::string lines_of(const History& history, const Measured& measured) {
  std::string lines;
  for (std::size_t i = 0; i < history.points.size(); ++i)
    if (const Measure value = measured(history.points[i])) lines += fmt::format("{} {:.8g}\n", i, *value);
  return lines;
}

}  // namespace

Figure history_plot(const History& history, Column column) {
  constexpr double kWidth = 16.0, kHeight = 15.0;  // [cm]
  Figure figure{.name = "history", .width = width_in(column, kWidth), .height = kHeight};
  Canvas canvas;
  figure.script = std::string(kFrame) +
                  fmt::format("set xrange [-0.5:{}]\n", static_cast<double>(history.points.size()) - 0.5) +
                  tics(history, false);
  const auto cases = static_cast<double>(history.cases);
  canvas.draw(lines_of(history,
                       [&](const HistoryPoint& point) {
                         return history.cases == 0
                                    ? Measure()
                                    : Measure(100.0 * static_cast<double>(point.certified) / cases);
                       }),
              kCurve, "run, certified [%]");
  figure.script += "set ylabel 'certified [%]'\nset offsets 0, 0, graph 0.1, graph 0.1\n" + canvas.panel();
  canvas.draw(lines_of(history, [](const HistoryPoint& point) { return point.error; }), kCurve,
              "run, median error [-]");
  figure.script +=
      "set ylabel 'error of x, median'\nset logscale y\nset format y '10^{%T}'\n" + canvas.panel();
  canvas.draw(lines_of(history, [](const HistoryPoint& point) { return point.seconds; }), kCurve,
              "run, mean time on the first machine [s]");
  figure.script += "set ylabel 'time, mean [s]'\nset format y '%.1e'\n" + tics(history, true) +
                   canvas.panel() + "unset multiplot\n";
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
