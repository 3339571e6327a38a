#include "harness/plots/history_plot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// "2026-11-29 0123456": date and the beginning of the commit of a run.
std::string label_of(const HistoryPoint& point) {
  return point.date.substr(0, 10) + " " + point.commit.substr(0, 7);
}

std::string tics(const History& history, bool named) {
  std::string list;
  for (std::size_t i = 0; i < history.points.size(); ++i)
    list += fmt::format("{}{} {}", i == 0 ? "" : ", ",
                        gnuplot_string(named ? label_of(history.points[i]) : ""), i);
  return fmt::format("set xtics ({}) rotate by -30 noenhanced\n", list);
}

}  // namespace

Figure history_plot(const History& history, Column column) {
  Figure figure{.name = "history", .width = width_in(column, 16.0), .height = 15.0};
  figure.script = panels(3, 1) +
                  fmt::format("set lmargin 10\nset xrange [-0.5:{}]\n",
                              static_cast<double>(history.points.size()) - 0.5) +
                  tics(history, false);
  Canvas canvas;
  const auto add = [&](const char* commands, const char* words, const auto& measured) {
    std::string lines;  // one per run that has the measure
    for (std::size_t i = 0; i < history.points.size(); ++i)
      if (const Measure value = measured(history.points[i])) lines += fmt::format("{} {:.8g}\n", i, *value);
    canvas.draw(lines, "using 1:2 with linespoints lc rgb '#0072B2' pt 7 ps 0.5 lw 1.2", words);
    figure.script += commands + canvas.panel();
  };
  add("set ylabel 'certified [%]'\nset offsets 0, 0, graph 0.1, graph 0.1\n", "run, certified [%]",
      [&](const HistoryPoint& point) {
        const double share =
            100.0 * static_cast<double>(point.certified) / static_cast<double>(history.cases);
        return history.cases == 0 ? Measure() : Measure(share);
      });
  add("set ylabel 'error of x, median'\nset logscale y\nset format y '10^{%T}'\n", "run, median error [-]",
      [](const HistoryPoint& point) { return point.error; });
  figure.script += tics(history, true);
  add("set ylabel 'time, mean [s]'\nset format y '%.1e'\n", "run, mean time on the first machine [s]",
      [](const HistoryPoint& point) { return point.seconds; });
  figure.script += "unset multiplot\n";
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
