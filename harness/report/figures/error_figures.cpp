// Error against time, against resolution, and against one constant in units of its scale, on each scene.

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/resolution_study.hpp"
#include "harness/report/figures/column.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// One answer.
struct ErrorMark {
  double cost = 0.0, error = 0.0;
  bool hollow = false;      ///< an error that ErrorCurve::hollow says something about
  std::string words = {};   ///< beside the mark, where there is room
  std::string source = {};  ///< the case, beside the numbers in the data
};

/// Answers of one method and the line through some of them.
struct ErrorCurve {
  std::string name = {}, label = {};  ///< in the data, in the figure
  std::size_t place = 0;              ///< of its style
  std::string hollow = {};            ///< what hollow marks are: "below ten error bars"
  std::vector<ErrorMark> marks = {};
  std::vector<std::pair<double, double>> line = {};  ///< costs and errors; none: the curve is not drawn
};

/// What the axes of a figure say, and how far down they go.
struct ErrorAxes {
  std::string cost = {}, error = {};
  double floor = 0.0;   ///< drawn as a line where it is not 0
  bool slopes = false;  ///< with triangles of orders 1 and 2
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
  Eigen::Array2d least = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()),
                 largest = Eigen::Array2d::Zero();  ///< costs and errors of the marks
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
    figure.least = figure.least.min(Eigen::Array2d(mark.cost, mark.error));
    figure.largest = figure.largest.max(Eigen::Array2d(mark.cost, mark.error));
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
unset key
)";

/// Triangles with the slopes of orders 1 and 2, at the lower left.
std::string slope_triangles(double least_cost, double low) {
  std::string script;
  double foot = 2.0 * low;
  for (const int order : {1, 2}) {
    const double from = 0.4 * least_cost, to = 0.8 * least_cost, top = foot * std::pow(to / from, order);
    script += fmt::format(
        "set object polygon from {0:.4e},{2:.4e} to {1:.4e},{3:.4e} to {0:.4e},{3:.4e} to {0:.4e},{2:.4e} "
        "fillstyle empty border lc rgb '#666666'\nset label '{4}' at {1:.4e},{5:.4e} left offset -0.6,0.3 "
        "font ',8' textcolor rgb '#666666'\n",
        from, to, top, foot, order, std::sqrt(foot * top));
    foot = 4.0 * top;
  }
  return script;
}

/// Where the curves are named, as commands that make room for it, and the rest of the figure's size.
/// \param low, high  of the error axis
std::string named_curves(const ErrorFigure& drawn, Column column, double low, double high, Figure& figure) {
  if (!is_narrow(column)) {
    std::size_t longest = 0;
    for (const NamedCurve& curve : drawn.curves) longest = std::max(longest, curve.name.size());
    const double room = std::min(0.5, (0.19 * static_cast<double>(longest) + 0.9) / figure.width);
    return fmt::format("set rmargin at screen {:.3f}\n", 1.0 - room) + names_beside(drawn.curves, low, high);
  }
  const double key = key_height(drawn.curves.size(), 1);
  figure.height = 7.6 + key;
  return fmt::format(
      "set bmargin at screen {:.3f}\nset key at screen 0.5,0.01 bottom center vertical maxcols 1 noenhanced "
      "Left reverse samplen 2 font ',8'\n",
      (key + 1.4) / figure.height);
}

/// The figure; without data if no curve has points.
Figure error_figure(const std::string& name, const std::string& caption, std::span<const ErrorCurve> curves,
                    const ErrorAxes& axes, Column column) {
  ErrorFigure drawn;
  for (const ErrorCurve& curve : curves) add_curve(curve, drawn);
  if (drawn.canvas.empty()) return {};
  constexpr double kMargin = 3.0;  // a factor
  const Eigen::Array2d least = drawn.least, largest = drawn.largest;
  const double lowest = axes.floor > 0.0 ? std::min(least.y(), axes.floor) : least.y();
  const double low = lowest / kMargin, high = largest.y() * kMargin;
  if (axes.floor > 0.0)
    drawn.canvas.plot(fmt::format("{:.6e} with lines lc rgb '#888888' dt 3 lw 1 notitle", axes.floor));
  Figure figure{
      .name = name, .caption = caption, .data = drawn.canvas.data(), .width = width_in(column, 17.0)};
  figure.script =
      std::string(kFrame) +
      fmt::format(kAxes, axes.cost, axes.error, least.x() / kMargin, largest.x() * kMargin, low, high) +
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
  if (axes.slopes) figure.script += slope_triangles(least.x(), low);
  figure.script += drawn.marks + drawn.canvas.panel();
  return figure;
}

/// The numbers of a resolution without their names: "40", "1e-6".
std::string resolution_text(const CaseChoice& choice) {
  std::string text;
  for (const auto& [key, value] : choice.settings)
    if (key != kStartSetting && is_numeric(value)) text += (text.empty() ? "" : ", ") + value;
  return text;
}

/// The curve of a study, its runs, and the runs whose errors are bounds.
/// \param cost  of a run; runs without one are left out
ErrorCurve curve_of(const ResolutionStudy& study, std::size_t place, const CostAxis& axis) {
  ErrorCurve curve{.name = study.configuration,
                   .label = label_of(study),
                   .place = place,
                   .hollow = "below ten error bars"};
  for (const CurvePoint& point : pareto_curve(study, axis))
    curve.line.emplace_back(point.cost, *point.run->error);
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> cost = axis.cost(*run.result);
    if (!run.error || !cost) continue;
    curve.marks.push_back({.cost = *cost,
                           .error = *run.error,
                           .hollow = run.bounded,
                           .words = resolution_text(*run.result->choice),
                           .source = run.result->choice->resolution});
  }
  return curve;
}

std::vector<ErrorCurve> curves_of(const Evaluation& evaluation,
                                  const std::vector<const ResolutionStudy*>& studies, const CostAxis& axis) {
  std::vector<ErrorCurve> curves;
  for (const ResolutionStudy* study : studies)
    curves.push_back(curve_of(*study, evaluation.place_of(study->configuration), axis));
  return curves;
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

/// Of the answers under the scene's law that are at a distance from an orbit: that, by the constant's value.
ErrorCurve curve_of(const Evaluation& evaluation, const std::string& method, const Variation& variation) {
  ErrorCurve curve{.name = method, .label = method, .hollow = "not certified"};
  for (const std::string& value : variation.values) {
    for (const CaseResult* result : variation.results.at(value)) {
      const Measure distance = evaluation.record_of(*result).certificate.distance;
      if (has_another_law(result->outcome) || !(distance.value_or(0.0) > 0.0)) continue;
      const Measure certified = certified_error(*result);
      const double error = certified.value_or(*distance);
      curve.marks.push_back({.cost = *number_in(value),
                             .error = error,
                             .hollow = !certified,
                             .source = result->choice->resolution});
      curve.line.emplace_back(curve.marks.back().cost, error);
    }
  }
  return curve;
}

/// Whether the values of an option are multiples of a scale, "10x", "1e3x", and its name is a word: records
/// may come from anywhere.
bool is_constant(const std::string& option, const Variation& variation) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0; };
  return std::ranges::all_of(option, is_letter) &&
         std::ranges::all_of(variation.values, [](const std::string& value) {
           const double number = number_in(value).value_or(0.0);
           return value.ends_with('x') && number > 0.0 && std::isfinite(number);
         });
}

}  // namespace

std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene,
                                           Column column) {
  std::vector<const ResolutionStudy*> competing, others;
  for (const ResolutionStudy& study : evaluation.studies_of(scene))
    (study.eligibility == Eligibility::another_law ? others : competing).push_back(&study);
  constexpr const char* kTime = "time, set-up and solve [s]";
  std::vector<Figure> figures{
      error_figure(scene + "-work-precision",
                   "Error against time. Each mark is a resolution, its number beside it. Hollow marks: error "
                   "too small to measure (below ten error bars of the orbit), not ranked.",
                   curves_of(evaluation, competing, time_axis()),
                   {kTime, "error of x and force [-]", floor_of(competing)}, column),
      error_figure(scene + "-other-laws",
                   "The same for methods that solve another impact law than the scene's: errors against the "
                   "motion under their own law.",
                   curves_of(evaluation, others, time_axis()),
                   {kTime, "error of x and force, own law [-]", floor_of(others)}, column)};
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
    if (resolutions.size() > 1) studies.push_back(&study);
  }
  return error_figure(scene + "-convergence",
                      "Error against the number of harmonics or samples that a method was asked for; "
                      "triangles have the slopes of orders 1 and 2.",
                      curves_of(evaluation, studies, resolution_axis()),
                      {"harmonics, or samples of a period [-]", "error of x and force [-]", 0.0, true},
                      column);
}

std::vector<Figure> option_figures(const Evaluation& evaluation, const std::string& scene, Column column) {
  constexpr std::size_t kFewestPoints = 3;
  // By option, then in the order in which the methods ran.
  std::map<std::string, std::map<const CaseResult*, ErrorCurve>> sorted;
  for (const auto& [varied, variation] : variations_of(evaluation.results_of(scene))) {
    const auto& [method, option] = varied;
    if (!is_constant(option, variation)) continue;
    ErrorCurve curve = curve_of(evaluation, method, variation);
    if (curve.line.size() >= kFewestPoints)
      sorted[option].emplace(variation.results.at(variation.values.front()).front(), std::move(curve));
  }
  std::vector<Figure> figures;
  for (auto& [option, by_result] : sorted) {
    std::vector<ErrorCurve> list;
    for (auto& [result, curve] : by_result) {
      curve.place = list.size();
      list.push_back(std::move(curve));
    }
    Figure figure =
        error_figure(fmt::format("{}-{}", scene, option),
                     fmt::format("Error against the {}. Hollow: the answer is not certified, and its "
                                 "distance is to the nearest orbit that was found from it.",
                                 option),
                     list, {fmt::format("{}, in units of its scale [-]", option), "error of x [-]"}, column);
    if (!figure.data.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace signorini
