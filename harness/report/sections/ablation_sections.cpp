#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "harness/plan/case_name.hpp"
#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/evaluation/work_precision.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr std::string_view kAblationText =
    R"(`plain=true` is a method as the literature has it, each further setting
adds one of our additions, and what is not plain is ours. All runs at the resolution of the plain ones, of
whatever law. Says converged tells whether the method gets to a solution of its equations, certified whether
that is near an orbit of its law, and on how many of these runs it is an unstable one. Medians of errors and times are over the certified runs of the row, easy ones
alone where few are certified. Ours over it compares equal scenes: the error of x of the last form of a method over
that of the row, the median over the scenes where both are certified by one orbit, and how many those are.)";

/// What one form of a method makes of the scenes.
struct Form {
  OutcomeCounts counts = {};
  std::vector<double> errors = {}, seconds = {};  ///< of certified runs
  /// Certified runs with an error, by scene.
  std::map<std::string_view, const CaseResult*> by_scene = {};
};

/// Where a form stands in its table: plain ones first, with more and more additions, then ours, with fewer
/// and fewer of them switched off; its name.
using FormPlace = std::tuple<bool, std::ptrdiff_t, std::string>;

bool has_start(const Settings& settings) {
  return std::ranges::find(settings, kStartSetting, &OptionSetting::first) != settings.end();
}

FormPlace place_of(const CaseChoice& choice) {
  const bool plain = choice.is_plain();
  const auto additions = std::ssize(choice.settings);
  return {!plain, plain ? additions : -additions, choice.resolution};
}

/// The method at its resolution, whatever its other settings.
std::string level_of(const CaseChoice& choice) {
  Settings numbers = choice.settings;
  std::erase_if(numbers, [](const OptionSetting& setting) { return !is_resolution(setting); });
  return method_label(choice.method, numbers);
}

void add(const CaseResult& result, Form& form) {
  form.counts.add(result.outcome);
  if (const Measure error = certified_error(result)) {
    form.errors.push_back(*error);
    form.by_scene[result.scene->name] = &result;
  }
  if (claim_of(result.outcome) == Claim::certified && result.seconds) form.seconds.push_back(*result.seconds);
}

/// Errors of `ours` over those of another form, where both are certified by one orbit.
std::vector<double> error_ratios(const Form& ours, const Form& other) {
  std::vector<double> ratios;
  for (const auto& [scene, a] : ours.by_scene) {
    const auto b = other.by_scene.find(scene);
    if (b == other.by_scene.end() || a->orbit == nullptr || a->orbit != b->second->orbit) continue;
    const double ratio = *certified_error(*a) / *certified_error(*b->second);
    if (std::isfinite(ratio)) ratios.push_back(ratio);
  }
  return ratios;
}

/// "0.17 (6)"; nothing to compare in the row of `ours`.
Cell ratio_cell(const Form& ours, const Form& form) {
  if (&form == &ours) return {"·", 1.0};
  const std::vector<double> ratios = error_ratios(ours, form);
  if (ratios.empty()) return {"-", kNeverReached};
  return {fmt::format("{:.2g} ({})", median(ratios), ratios.size()), median(ratios)};
}

std::vector<Cell> row_of(const FormPlace& place, const Form& form, const Form& ours) {
  const OutcomeCounts& n = form.counts;
  const auto middle = [](const std::vector<double>& values, const auto& print) -> Cell {
    if (values.empty()) return {"-", kNeverReached};
    return {print(median(values)), median(values)};
  };
  return {std::get<std::string>(place),
          count_cell(n.applicable()),
          count_cell(n.claims()),
          n.unstable == 0 ? count_cell(n.certified)
                          : Cell(fmt::format("{} ({} unstable)", n.certified, n.unstable), n.certified),
          count_cell(n.refuted),
          middle(form.errors, [](double error) { return fmt::format("{:.1e}", error); }),
          ratio_cell(ours, form),
          middle(form.seconds, time_text)};
}

}  // namespace

Sections ablation_sections(const Evaluation& evaluation) {
  std::map<std::string, std::map<FormPlace, Form>> levels;
  for (const CaseResult& result : evaluation.results()) {
    const CaseChoice& choice = *result.choice;
    if (!has_start(choice.settings)) add(result, levels[level_of(choice)][place_of(choice)]);
  }
  Section section{.id = "ablation", .title = "From the literature's forms to ours"};
  section.text = kAblationText;
  section.table.header = {"form",    "runs",       "says converged", "certified",
                          "refuted", "error of x", "ours over it",   "time"};
  for (const auto& [level, forms] : levels) {
    const bool compares = forms.size() > 1 && !std::get<bool>(forms.begin()->first);
    if (!compares) continue;
    const Form& ours = forms.rbegin()->second;
    for (const auto& [place, form] : forms) section.table.rows.push_back(row_of(place, form, ours));
  }
  return {std::move(section)};
}

}  // namespace signorini
