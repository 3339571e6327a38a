#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "harness/plan/case_name.hpp"
#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/resolution_study.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr std::size_t kFewestValues = 3;

/// The results by scene, of several the first.
std::map<std::string_view, const CaseResult*> by_scene(const std::vector<const CaseResult*>& results) {
  std::map<std::string_view, const CaseResult*> scenes;
  for (const CaseResult* result : results) scenes.try_emplace(result->scene->name, result);
  return scenes;
}

/// The error of x with a switch off over that with it on; empty unless both answers are certified, of the
/// same orbit, and neither error is below what is known of that.
std::optional<double> gain_of(const CaseResult& off, const CaseResult& on) {
  const auto known = [](const CaseResult& result) {
    return certified_error(result).value_or(0.0) > result.measurable;
  };
  if (!known(off) || !known(on) || off.orbit != on.orbit) return std::nullopt;
  return *certified_error(off) / *certified_error(on);
}

Cell gain_cell(const Measure& gain) { return gain ? number_cell(gain, "{:.3g}", "none") : Cell("none"); }

/// Results of one method at one value.
struct Results {
  OutcomeCounts counts = {};
  std::vector<double> errors = {};  ///< of applicable cases of the scene's law, infinite where not solved
};

Results results_of(const std::vector<const CaseResult*>& cases) {
  Results results;
  for (const CaseResult* one : cases) {
    if (one->outcome.status == Status::not_applicable) continue;
    results.counts.add(one->outcome);
    if (!has_another_law(one->outcome))
      results.errors.push_back(certified_error(*one).value_or(kNeverReached));
  }
  return results;
}

/// Of the errors one that there is, if there are any.
Cell error_cell(const std::vector<double>& errors, const auto& of) {
  return errors.empty() ? Cell("-") : number_cell(of(errors), "{:.1e}", "not solved");
}

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

Measure median_of(const std::vector<double>& values) { return values.empty() ? Measure() : median(values); }

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
  Cell cell = number_cell(median_of(ratios), "{:.2g}");
  if (!ratios.empty()) cell.text += fmt::format(" ({})", ratios.size());
  return cell;
}

std::vector<Cell> row_of(const FormPlace& place, const Form& form, const Form& ours) {
  const OutcomeCounts& n = form.counts;
  return {std::get<std::string>(place),
          count_cell(n.applicable()),
          count_cell(n.claims()),
          n.unstable == 0 ? count_cell(n.certified)
                          : Cell(fmt::format("{} ({} unstable)", n.certified, n.unstable), n.certified),
          count_cell(n.refuted),
          number_cell(median_of(form.errors), "{:.1e}"),
          ratio_cell(ours, form),
          time_cell(median_of(form.seconds))};
}

}  // namespace

Sections sensitivity_sections(const Evaluation& evaluation) {
  Section section{.id = "sensitivity", .title = "Sensitivity to one option at a time"};
  section.text =
      "The same scenes at several values of one option, the others as stated. Solved: certified answers "
      "under the law of the scene; reference orbit: answers that are the motion reached from rest, of "
      "whatever law. Errors of x against the certified orbit, on scenes of that law; a failure counts as "
      "infinite. `start`: the solve starts from the orbit reached from rest, late by this share of its "
      "period.";
  section.table.header = {"method",  "option",       "value",         "solved",           "reference orbit",
                          "refuted", "median error", "largest error", "under another law"};
  for (const auto& [varied, variation] : variations_of(evaluation.results())) {
    if (variation.values.size() < kFewestValues) continue;
    for (const std::string& value : variation.values) {
      const auto& [counts, errors] = results_of(variation.results.at(value));
      if (counts.cases == 0) continue;
      section.table.rows.push_back(
          {varied.first, varied.second, value, count_cell(counts.solved, counts.own_law()),
           count_cell(counts.same_orbit), count_cell(counts.refuted), error_cell(errors, median),
           error_cell(errors, std::ranges::max), count_cell(counts.solved_under_another_law())});
    }
  }
  return {std::move(section)};
}

Sections switch_sections(const Evaluation& evaluation) {
  Section summary{.id = "switches", .title = "One switch off and on"};
  summary.text =
      "The same scenes with one option false and true, the others as stated. Gain: error of x with it off "
      "over that with it on, where both answers are certified and of the same orbit.";
  summary.table.header = {
      "method",     "switch",      "scenes",      "solved with it off", "solved with it on",
      "least gain", "median gain", "largest gain"};
  Section scenes{.id = "switches-scenes", .title = "One switch off and on, scene by scene"};
  scenes.table.header = {"scene", "method", "switch", "error of x, off", "error of x, on", "gain"};
  Rows rows(scenes, "what the others say is in table.csv");
  for (const auto& entry : variations_of(evaluation.results())) {
    const auto& varied = entry.first;
    const auto& results = entry.second.results;
    if (results.size() != 2 || !results.contains("false") || !results.contains("true")) continue;
    std::vector<double> gains;
    const auto switched_on = by_scene(results.at("true"));
    for (const CaseResult* off : results.at("false")) {
      const auto on = switched_on.find(off->scene->name);
      if (on == switched_on.end() || off->outcome.status == Status::not_applicable) continue;
      const std::optional<double> gain = gain_of(*off, *on->second);
      if (gain) gains.push_back(*gain);
      rows.add([&] {
        return std::vector<Cell>{off->scene->name,
                                 varied.first,
                                 varied.second,
                                 error_text(evaluation.record_of(*off)),
                                 error_text(evaluation.record_of(*on->second)),
                                 gain_cell(gain)};
      });
    }
    const OutcomeCounts off = results_of(results.at("false")).counts,
                        on = results_of(results.at("true")).counts;
    std::vector<Cell> row{varied.first, varied.second, count_cell(on.cases), count_cell(off.solved),
                          count_cell(on.solved)};
    const auto add_gain = [&](const auto& of) {
      row.push_back(gain_cell(gains.empty() ? Measure() : of(gains)));
    };
    add_gain(std::ranges::min);
    add_gain(median);
    add_gain(std::ranges::max);
    summary.table.rows.push_back(std::move(row));
  }
  rows.close();
  return {std::move(summary), std::move(scenes)};
}

Sections repeat_sections(const Evaluation& evaluation) {
  struct Tally {
    int cases = 0, identical = 0, solves = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const CaseResult& result : evaluation.results()) {
    if (!result.repeats) continue;
    Tally& tally = tallies[result.choice->method];
    ++tally.cases;
    tally.solves += result.repeats->solves;
    tally.identical += result.repeats->identical == result.repeats->solves ? 1 : 0;
  }
  Section section{.id = "repeats", .kind = SectionKind::origin, .title = "Repeated solves"};
  section.text =
      "Cases solved again, in the same process and in others, and those of them whose every answer had the "
      "same bits as the first.";
  section.table.header = {"method", "cases solved again", "solves compared", "same bits"};
  for (const auto& [method, tally] : tallies)
    section.table.rows.push_back({method, count_cell(tally.cases), count_cell(tally.solves),
                                  count_cell(tally.identical, tally.cases)});
  return {std::move(section)};
}

Sections ablation_sections(const Evaluation& evaluation) {
  std::map<std::string, std::map<FormPlace, Form>> levels;
  for (const CaseResult& result : evaluation.results()) {
    const CaseChoice& choice = *result.choice;
    if (!has_start(choice.settings)) add(result, levels[level_of(choice)][place_of(choice)]);
  }
  Section section{.id = "ablation", .title = "From the literature's forms to ours"};
  section.text = R"(`plain=true` is a method as the literature has it, each further setting
adds one of our additions, and what is not plain is ours. All runs at the resolution of the plain ones, of
whatever law. Says converged tells whether the method gets to a solution of its equations, certified whether
that is near an orbit of its law, and on how many of these runs it is an unstable one. Medians of errors and times are over the certified runs of the row, easy ones
alone where few are certified. Ours over it compares equal scenes: the error of x of the last form of a method over
that of the row, the median over the scenes where both are certified by one orbit, and how many those are.)";
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
