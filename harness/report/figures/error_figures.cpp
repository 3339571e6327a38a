// Error against time, and against resolution, on each scene.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/figures/error_canvas.hpp"
#include "harness/report/figures/figures.hpp"

namespace signorini {

namespace {

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

}  // namespace

std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene,
                                           Column column) {
  std::vector<const ResolutionStudy*> competing, others;
  for (const ResolutionStudy& study : evaluation.studies_of(scene))
    (study.eligibility == Eligibility::another_law ? others : competing).push_back(&study);
  constexpr const char* kTime = "time, set-up and solve [s]";
  std::vector<Figure> figures{
      error_figure(scene + "-work-precision", curves_of(evaluation, competing, time_axis()),
                   {kTime, "error of x and force [-]", floor_of(competing)}, column),
      error_figure(scene + "-other-laws", curves_of(evaluation, others, time_axis()),
                   {kTime, "error of x and force, own law [-]", floor_of(others)}, column)};
  figures[0].caption =
      "Error against time. Each mark is a resolution, its number beside it. Hollow marks: error too small to "
      "measure (below ten error bars of the orbit), not ranked.";
  figures[1].caption =
      "The same for methods that solve another impact law than the scene's: errors against the motion under "
      "their own law.";
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
  Figure figure =
      error_figure(scene + "-convergence", curves_of(evaluation, studies, resolution_axis()),
                   {"harmonics, or samples of a period [-]", "error of x and force [-]", 0.0, true}, column);
  if (figure.data.empty()) return {};
  figure.caption =
      "Error against the number of harmonics or samples that a method was asked for; triangles have the "
      "slopes of orders 1 "
      "and 2.";
  return figure;
}

}  // namespace signorini
