// Error against the value of one constant, in units of its scale.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/evaluation/variations.hpp"
#include "harness/report/figures/error_canvas.hpp"
#include "harness/report/figures/figures.hpp"

namespace signorini {

namespace {

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
        error_figure(fmt::format("{}-{}", scene, option), list,
                     {fmt::format("{}, in units of its scale [-]", option), "error of x [-]"}, column);
    if (figure.data.empty()) continue;
    figure.caption = fmt::format(
        "Error against the {}. Hollow: the answer is not certified, and its distance is to the nearest "
        "orbit that was found from it.",
        option);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace signorini
