// Amplitude over frequency: the exact response under those of the methods.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// The parts of branches that are stable, or are not, or all of them, as lines with gaps between them.
std::string lines_of(const std::vector<DrawnBranch>& branches, std::optional<bool> stable = {}) {
  std::string lines;
  for (const DrawnBranch& branch : branches) {
    bool drawing = false;
    const auto belongs = [&](std::size_t i) { return !stable || (branch.stable[i] == 1) == *stable; };
    for (std::size_t i = 0; i < branch.frequency.size(); ++i) {
      // A piece belongs to the kind of its first point, so that the kinds meet.
      const bool drawn = belongs(i) || (i > 0 && belongs(i - 1));
      if (drawn)
        lines += fmt::format("{:.8g} {:.6g}\n", branch.frequency[i], branch.amplitude[i]);
      else if (drawing)
        lines += "\n";
      drawing = drawn;
    }
    if (drawing) lines += "\n";
  }
  return lines;
}

bool moves(const Record& record) {
  return std::ranges::any_of(record.response->branches, [](const DrawnBranch& branch) {
    return std::ranges::any_of(branch.amplitude, [](double amplitude) { return amplitude > 0.0; });
  });
}

/// The method's own branches, or the points of its steps, over the exact ones. What never moves has no
/// logarithm.
std::string panel(const Record& record, const Record& exact, std::optional<int> stable,
                  std::optional<int> unstable, Canvas& canvas) {
  canvas.plot(stable, "with lines lc rgb '#bbbbbb' lw 4");
  canvas.plot(unstable, "with lines lc rgb '#bbbbbb' lw 2 dt (8,6)");
  const bool by_steps = record.response->question.way == ResponseWay::steps;
  canvas.draw(lines_of(record.response->branches),
              by_steps ? "with points lc rgb '#D55E00' pt 6 ps 0.3" : "with lines lc rgb '#0072B2' lw 1");
  const char* const scale = moves(record) || moves(exact) ? "set logscale y\nset format y '10^{%T}'\n"
                                                          : "unset logscale y\nset format y '%g'\n";
  return fmt::format("{}set title {} noenhanced\n{}", scale, gnuplot_string(label_with_law(record)),
                     canvas.panel());
}

Figure response_figure(const Record& exact, std::span<const Record> records, Column column) {
  const ResponseQuestion& asked = exact.response->question;
  Canvas canvas;
  const auto stable = canvas.add(lines_of(exact.response->branches, true));
  const auto unstable = canvas.add(lines_of(exact.response->branches, false));
  std::string drawn;
  int count = 0;
  for (const Record& record : records) {
    if (is_exact(record) || record.scene != exact.scene || record.response->branches.empty()) continue;
    drawn += panel(record, exact, stable, unstable, canvas);
    if (count++ == 0) drawn += "unset label 1\n";  // once is enough
  }
  const bool narrow = is_narrow(column);
  const int columns = narrow ? 1 : 3, rows = std::max(1, (count + columns - 1) / columns);
  // Room for what the colours mean below the panels, then for titles and numbers, in shares of the figure.
  const double words = narrow ? 1.2 : 0.4, height = rows * 4.6 + words - 0.4;  // [cm]
  const double bottom = (0.9 + words) / height, top = 1.0 - 0.8 / height, between = 1.4 / height;
  const std::string layout = fmt::format(" margins {:.2f},0.99,{:.4f},{:.4f} spacing 0.05,{:.4f}",
                                         narrow ? 0.14 : 0.07, bottom, top, between);
  return {
      .name = exact.scene + "-response",
      .caption = "Amplitude over the frequency of the load, " + exact.scene +
                 ": exact branches grey, unstable parts dashed; curves by arc length blue, steps orange",
      .script =
          panels(rows, columns, layout) +
          fmt::format("set title font ',8' offset 0,-0.6\nset label 1 \"amplitude [m] over frequency of the "
                      "load [rad/s]; {0}grey: exact, dashed where unstable; {0}blue: by arc length; orange: "
                      "by steps\" at screen 0.5,{1:.4f} center font ',8'\nset xrange [{2:.8g}:{3:.8g}]\n",
                      narrow ? "\\n" : "", words / height, std::min(asked.from, asked.to),
                      std::max(asked.from, asked.to)) +
          drawn + "unset multiplot\n",
      .data = canvas.data(),
      .width = width_in(column, 18.0),
      .height = height};
}

}  // namespace

std::vector<Figure> response_figures(const Evaluation& evaluation, Column column) {
  const std::vector<Record>& records = evaluation.responses();
  std::vector<Figure> figures;
  for (const Record& exact : records) {
    const bool followed = std::ranges::any_of(records, [&](const Record& other) {
      return !is_exact(other) && other.scene == exact.scene && !other.response->branches.empty();
    });
    if (is_exact(exact) && !exact.response->branches.empty() && followed)
      figures.push_back(response_figure(exact, records, column));
  }
  return figures;
}

}  // namespace signorini
