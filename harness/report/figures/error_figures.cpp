// Error against time, and against resolution, on each scene.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// The ranges of what is drawn on two logarithmic axes.
struct Extremes {
  double least_cost = kNeverReached, largest_cost = 0.0, least_error = kNeverReached, largest_error = 0.0;

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
  Extremes extremes = {};
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

/// The numbers of a resolution without their names: "40", "1e-6".
std::string resolution_text(const CaseChoice& choice) {
  std::string text;
  for (const auto& [key, value] : choice.settings)
    if (key != kStartSetting && is_numeric(value)) text += (text.empty() ? "" : ", ") + value;
  return text;
}

/// Adds the curve of a study, its runs, and the runs whose errors are bounds.
/// \param cost  of a run; runs without one are left out
void add_study(const ResolutionStudy& study, std::size_t place, const std::string& label,
               const CostAxis& axis, ErrorFigure& figure) {
  const LineStyle style = line_style(place);
  std::string curve, runs, bounds;
  for (const CurvePoint& point : pareto_curve(study, axis))
    curve += fmt::format("{:.6e} {:.6e}\n", point.cost, *point.run->error);
  if (curve.empty()) return;
  NamedCurve named{.name = label, .colour = line_colour(place), .style = style.line + " " + style.mark};
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> cost = axis.cost(*run.result);
    if (!run.error || !cost) continue;
    figure.extremes.stretch(*cost, *run.error);
    std::string& list = run.bounded ? bounds : runs;
    list += fmt::format("{:.6e} {:.6e}  # {}\n", *cost, *run.error, run.result->choice->resolution);
    figure.name_mark(*cost, *run.error, resolution_text(*run.result->choice), named.colour);
    if (*cost >= named.cost) {
      named.cost = *cost;
      named.error = *run.error;
    }
  }
  figure.canvas.draw(curve, fmt::format("with lines {} notitle", style.line),
                     study.configuration + ", curve");
  figure.canvas.draw(runs, fmt::format("with points {} ps 1.1 notitle", style.filled),
                     study.configuration + ", runs");
  figure.canvas.draw(bounds, fmt::format("with points {} ps 1.1 notitle", style.hollow),
                     study.configuration + ", runs below ten error bars");
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

/// Ten error bars of the least certain orbit.
double floor_of(const std::vector<const ResolutionStudy*>& studies) {
  double floor = 0.0;
  for (const ResolutionStudy* study : studies) {
    for (const ScoredRun& run : study->runs) {
      if (run.error) floor = std::max(floor, run.result->measurable);
    }
  }
  return floor;
}

std::string label_of(const ResolutionStudy& study) {
  const RepresentedLaw* law = study.runs.front().result->law;
  if (study.eligibility != Eligibility::another_law || law == nullptr) return study.configuration;
  return fmt::format("{} ({})", study.configuration, law_text(*law));
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

/// What the axes of a figure say, and how far down they go.
struct ErrorAxes {
  const CostAxis& axis;
  std::string cost = {}, error = {};
  double floor = 0.0;   ///< drawn as a line where it is not 0
  bool slopes = false;  ///< with triangles of orders 1 and 2
};

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

Figure figure_of(const Evaluation& evaluation, const std::vector<const ResolutionStudy*>& studies,
                 const std::string& name, const ErrorAxes& axes, Column column) {
  ErrorFigure drawn;
  for (const ResolutionStudy* study : studies)
    add_study(*study, evaluation.place_of(study->configuration), label_of(*study), axes.axis, drawn);
  if (drawn.canvas.empty()) return {};
  constexpr double kMargin = 3.0, kUsualWidth = 17.0;  // [-], [cm]
  const Extremes& e = drawn.extremes;
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

/// The number of harmonics, samples, elements: whatever single whole number above 1 was asked for.
const CostAxis& resolution_axis() {
  static const CostAxis axis{.name = "resolution",
                             .cost = [](const CaseResult& result) -> std::optional<double> {
                               std::optional<double> found;
                               for (const auto& [key, value] : result.choice->settings) {
                                 if (key == kStartSetting || !is_numeric(value)) continue;
                                 const double number = std::strtod(value.c_str(), nullptr);
                                 if (found || number < 2.0 || number != std::floor(number))
                                   return std::nullopt;
                                 found = number;
                               }
                               return found;
                             }};
  return axis;
}

}  // namespace

std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene,
                                           Column column) {
  std::vector<const ResolutionStudy*> competing, others;
  for (const ResolutionStudy& study : evaluation.studies_of(scene))
    (study.eligibility == Eligibility::another_law ? others : competing).push_back(&study);
  constexpr const char* kTime = "time, set-up and solve [s]";
  std::vector<Figure> figures{
      figure_of(evaluation, competing, scene + "-work-precision",
                {time_axis(), kTime, "error of x [-]", floor_of(competing)}, column),
      figure_of(evaluation, others, scene + "-other-laws",
                {time_axis(), kTime, "error of x, own law [-]", floor_of(others)}, column)};
  figures[0].caption =
      "Error against time. Each mark is a resolution, its number beside it; hollow ones lie below ten error "
      "bars of the orbit and are not ranked.";
  figures[1].caption =
      "The same for methods that represent another law than the scene's: errors against the motion under "
      "their "
      "own.";
  std::erase_if(figures, [](const Figure& figure) { return figure.data.empty(); });
  return figures;
}

Figure convergence_figure(const Evaluation& evaluation, const std::string& scene, Column column) {
  std::vector<const ResolutionStudy*> studies;
  for (const ResolutionStudy& study : evaluation.studies_of(scene)) {
    if (study.eligibility == Eligibility::another_law) continue;
    std::set<double> resolutions;
    for (const ScoredRun& run : study.runs)
      if (const auto number = resolution_axis().cost(*run.result); number && run.error && !run.bounded)
        resolutions.insert(*number);
    if (resolutions.size() < 2) continue;
    studies.push_back(&study);
  }
  const ErrorAxes axes{resolution_axis(), "harmonics, or samples of a period [-]", "error of x [-]", 0.0,
                       true};
  Figure figure = figure_of(evaluation, studies, scene + "-convergence", axes, column);
  if (figure.data.empty()) return {};
  figure.caption =
      "Error against the number of harmonics or samples that a method was asked for; triangles have the "
      "slopes of orders 1 "
      "and 2.";
  return figure;
}

}  // namespace signorini
