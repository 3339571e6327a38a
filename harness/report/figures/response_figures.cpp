// Amplitude over frequency: the exact response under those of the methods.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// The parts of branches that are stable, or are not, as lines with gaps between them.
std::string lines_of(const std::vector<DrawnBranch>& branches, bool stable) {
  std::string lines;
  for (const DrawnBranch& branch : branches) {
    bool drawing = false;
    for (std::size_t i = 0; i < branch.frequency.size(); ++i) {
      // A piece belongs to the kind of its first point, so that the kinds meet.
      const bool here = (branch.stable[i] == 1) == stable;
      const bool before = i > 0 && (branch.stable[i - 1] == 1) == stable;
      if (here || before)
        lines += fmt::format("{:.8g} {:.6g}\n", branch.frequency[i], branch.amplitude[i]);
      else if (drawing)
        lines += "\n";
      drawing = here || before;
    }
    if (drawing) lines += "\n";
  }
  return lines;
}

/// All branches, with gaps between them.
std::string lines_of(const std::vector<DrawnBranch>& branches) {
  std::string lines;
  for (const DrawnBranch& branch : branches) {
    for (std::size_t i = 0; i < branch.frequency.size(); ++i)
      lines += fmt::format("{:.8g} {:.6g}\n", branch.frequency[i], branch.amplitude[i]);
    lines += "\n";
  }
  return lines;
}

constexpr double kUsualWidth = 18.0, kPanelHeight = 4.6;  // [cm]

constexpr std::string_view kResponsePanels =
    R"(set multiplot layout {},{} margins {:.2f},0.99,{:.4f},{:.4f} spacing 0.05,{:.4f}
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror
set tics font ',8'
set title font ',8' offset 0,-0.6
set label 1 "amplitude [m] over frequency of the load [rad/s]; {}grey: exact, dashed where unstable; {}blue: by arc length; orange: by steps" at screen 0.5,{:.4f} center font ',8'
set xrange [{:.8g}:{:.8g}]
unset key
)";

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
  std::string panels;
  int count = 0;
  for (const Record& record : records) {
    if (is_exact(record) || record.scene != exact.scene || record.response->branches.empty()) continue;
    panels += panel(record, exact, stable, unstable, canvas);
    if (count++ == 0) panels += "unset label 1\n";  // once is enough
  }
  const bool narrow = is_narrow(column);
  const int columns = narrow ? 1 : 3, rows = std::max(1, (count + columns - 1) / columns);
  constexpr double kCaption = 0.4, kCaptionLines = 1.2;  // [cm]
  const double more = narrow ? kCaptionLines - kCaption : 0.0, height = rows * kPanelHeight + more;
  // Room for titles and numbers, in shares of the figure.
  const double bottom = (1.3 + more) / height, top = 1.0 - 0.8 / height, between = 1.4 / height;
  const double caption = (narrow ? kCaptionLines : kCaption) / height;
  const char* const line_end = narrow ? "\\n" : "";
  return {.name = exact.scene + "-response",
          .caption = "Amplitude over the frequency of the load, " + exact.scene +
                     ": exact branches grey, unstable parts dashed; curves by arc length blue, steps orange",
          .script = fmt::format(kResponsePanels, rows, columns, narrow ? 0.14 : 0.07, bottom, top, between,
                                line_end, line_end, caption, std::min(asked.from, asked.to),
                                std::max(asked.from, asked.to)) +
                    panels + "unset multiplot\n",
          .data = canvas.data(),
          .width = width_in(column, kUsualWidth),
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
