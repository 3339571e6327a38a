#include "harness/report/figures/error_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// The ranges of what is drawn on two logarithmic axes.
struct DrawnRange {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least_cost = kInfinity, largest_cost = 0.0, least_error = kInfinity, largest_error = 0.0;

  void stretch(double cost, double error) {
    least_cost = std::min(least_cost, cost);
    largest_cost = std::max(largest_cost, cost);
    least_error = std::min(least_error, error);
    largest_error = std::max(largest_error, error);
  }
};

/// A curve that is named at its end.
struct NamedCurve {
  std::string name = {}, colour = {};
  double cost = 0.0, error = 0.0;  ///< its end
  std::string style = {};          ///< of its line and marks
};

/// One figure of errors over a cost.
struct ErrorFigure {
  Canvas canvas = {};
  DrawnRange extremes = {};
  std::vector<NamedCurve> curves = {};
  std::string marks = {};  ///< commands that write resolutions beside marks
  std::vector<std::pair<double, double>> named_marks = {};

  /// Writes a resolution beside a mark, unless another one stands there.
  void name_mark(double cost, double error, const std::string& words, const std::string& colour) {
    constexpr double kNear = 0.12;  // decades
    const auto near = [&](const std::pair<double, double>& other) {
      return std::abs(std::log10(other.first / cost)) < kNear &&
             std::abs(std::log10(other.second / error)) < kNear;
    };
    if (!(error > 0.0) || std::ranges::any_of(named_marks, near)) return;
    named_marks.emplace_back(cost, error);
    marks += fmt::format("set label {} at {:.6e},{:.6e} offset 0.4,0.5 font ',7' textcolor {} noenhanced\n",
                         gnuplot_string(words), cost, error, colour.substr(3));
  }
};

/// Adds a curve, its filled marks and its hollow ones; nothing where the curve has no points.
void add_curve(const ErrorCurve& curve, ErrorFigure& figure) {
  const LineStyle style = line_style(curve.place);
  std::string line, filled, hollow;
  for (const auto& [cost, error] : curve.line) line += fmt::format("{:.6e} {:.6e}\n", cost, error);
  if (line.empty()) return;
  NamedCurve named{
      .name = curve.label, .colour = line_colour(curve.place), .style = style.line + " " + style.mark};
  for (const ErrorMark& mark : curve.marks) {
    figure.extremes.stretch(mark.cost, mark.error);
    std::string& list = mark.hollow ? hollow : filled;
    list += fmt::format("{:.6e} {:.6e}  # {}\n", mark.cost, mark.error, mark.source);
    figure.name_mark(mark.cost, mark.error, mark.words, named.colour);
    if (mark.cost >= named.cost) {
      named.cost = mark.cost;
      named.error = mark.error;
    }
  }
  figure.canvas.draw(line, fmt::format("with lines {} notitle", style.line), curve.name + ", curve");
  figure.canvas.draw(filled, fmt::format("with points {} ps 1.1 notitle", style.filled),
                     curve.name + ", runs");
  figure.canvas.draw(hollow, fmt::format("with points {} ps 1.1 notitle", style.hollow),
                     fmt::format("{}, runs {}", curve.name, curve.hollow));
  figure.curves.push_back(std::move(named));
}

/// Names of curves right of the panel, in the order of their ends, a thin line from each end to its name.
/// \param low, high  of the error axis
std::string names_beside(std::vector<NamedCurve> curves, double low, double high) {
  constexpr double kApart = 0.062;  // of the height of the panel
  std::ranges::sort(curves, {}, &NamedCurve::error);
  std::vector<double> heights;
  for (const NamedCurve& curve : curves) {
    const double own = std::log(curve.error / low) / std::log(high / low);
    heights.push_back(heights.empty() ? own : std::max(own, heights.back() + kApart));
  }
  // Pushed down again from the top, so that none is above the panel.
  double most = 1.0;
  for (auto height = heights.rbegin(); height != heights.rend(); ++height) {
    *height = std::min(*height, most);
    most = *height - kApart;
  }
  std::string script;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const NamedCurve& curve = curves[i];
    script += fmt::format(
        "set label {} at graph 1.06,{:.4f} left font ',9' textcolor {} noenhanced\n"
        "set arrow from {:.6e},{:.6e} to graph 1.05,{:.4f} nohead {} lw 0.5 back\n",
        gnuplot_string(curve.name), heights[i], curve.colour.substr(3), curve.cost, curve.error, heights[i],
        curve.colour);
  }
  return script;
}

constexpr std::string_view kAxes = R"(set logscale xy
set format '10^{{%T}}'
set xlabel '{}'
set ylabel '{}'
set xrange [{:.2e}:{:.2e}]
set yrange [{:.2e}:{:.2e}]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
)";

/// A key below the panel, in one column.
constexpr std::string_view kKeyBelow =
    "set key at screen 0.5,0.01 bottom center vertical maxcols 1 noenhanced Left reverse samplen 2 font "
    "',8'\n";

/// Triangles with the slopes of orders 1 and 2, at the lower left.
std::string slope_triangles(double least_cost, double low) {
  std::string script;
  double foot = 2.0 * low;
  for (const int order : {1, 2}) {
    const double from = 0.4 * least_cost, to = 0.8 * least_cost, top = foot * std::pow(to / from, order);
    script += fmt::format(
        "set object polygon from {0:.4e},{2:.4e} to {1:.4e},{3:.4e} to {0:.4e},{3:.4e} to {0:.4e},{2:.4e} "
        "fillstyle empty border "
        "lc rgb '#666666'\nset label '{4}' at {1:.4e},{5:.4e} left offset -0.6,0.3 font ',8' textcolor rgb "
        "'#666666'\n",
        from, to, top, foot, order, std::sqrt(foot * top));
    foot = 4.0 * top;
  }
  return script;
}

/// Where the curves are named, as commands that make room for it, and the rest of the figure's size.
/// \param low, high  of the error axis
std::string named_curves(const ErrorFigure& drawn, Column column, double low, double high, Figure& figure) {
  if (!is_narrow(column)) {
    constexpr double kLetter = 0.19, kBeside = 0.9;  // [cm]
    std::size_t longest = 0;
    for (const NamedCurve& curve : drawn.curves) longest = std::max(longest, curve.name.size());
    const double room = std::min(0.5, (kLetter * static_cast<double>(longest) + kBeside) / figure.width);
    return fmt::format("set rmargin at screen {:.3f}\n", 1.0 - room) + names_beside(drawn.curves, low, high);
  }
  constexpr double kPanelAndAxis = 7.6, kAxis = 1.4;  // [cm]
  const double key = key_height(drawn.curves.size(), 1);
  figure.height = kPanelAndAxis + key;
  return fmt::format("set bmargin at screen {:.3f}\n{}", (key + kAxis) / figure.height, kKeyBelow);
}

}  // namespace

Figure error_figure(const std::string& name, std::span<const ErrorCurve> curves, const ErrorAxes& axes,
                    Column column) {
  ErrorFigure drawn;
  for (const ErrorCurve& curve : curves) add_curve(curve, drawn);
  if (drawn.canvas.empty()) return {};
  constexpr double kMargin = 3.0, kUsualWidth = 17.0;  // [-], [cm]
  const DrawnRange& e = drawn.extremes;
  const double lowest = axes.floor > 0.0 ? std::min(e.least_error, axes.floor) : e.least_error;
  const double low = lowest / kMargin, high = e.largest_error * kMargin;
  if (axes.floor > 0.0)
    drawn.canvas.plot(fmt::format("{:.6e} with lines lc rgb '#888888' dt 3 lw 1 notitle", axes.floor));
  Figure figure{.name = name, .data = drawn.canvas.data(), .width = width_in(column, kUsualWidth)};
  figure.script =
      fmt::format(kAxes, axes.cost, axes.error, e.least_cost / kMargin, e.largest_cost * kMargin, low, high) +
      named_curves(drawn, column, low, high, figure);
  if (is_narrow(column))
    for (const NamedCurve& curve : drawn.curves)
      drawn.canvas.plot(
          fmt::format("keyentry with linespoints {} title {}", curve.style, gnuplot_string(curve.name)));
  if (axes.floor > 0.0)
    figure.script += fmt::format(
        "set label '10 error bars' at graph 0.99, first {:.6e} right offset 0,-0.6 font ',7' textcolor rgb "
        "'#888888'\n",
        axes.floor);
  if (axes.slopes) figure.script += slope_triangles(e.least_cost, low);
  figure.script += drawn.marks + drawn.canvas.panel();
  return figure;
}

}  // namespace signorini
