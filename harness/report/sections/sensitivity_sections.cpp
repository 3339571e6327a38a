#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/evaluation/variations.hpp"
#include "harness/report/evaluation/work_precision.hpp"
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

Cell gain_cell(double gain) { return {fmt::format("{:.3g}", gain), gain}; }

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

Cell error_cell(double error) {
  return {std::isfinite(error) ? fmt::format("{:.1e}", error) : "not solved", error};
}

}  // namespace

Sections sensitivity_sections(const Evaluation& evaluation) {
  Section section{.id = "sensitivity", .title = "Sensitivity to one option at a time"};
  section.text =
      "The same scenes at several values of one option, the others as stated. Solved: "
      "certified answers under the law of the scene; reference orbit: answers that are the motion reached "
      "from "
      "rest, of whatever law. Errors of x against the certified orbit, on scenes of that law; a failure "
      "counts "
      "as infinite. `start`: the solve starts from the orbit reached "
      "from rest, late by this share of its period.";
  section.table.header = {"method",  "option",       "value",         "solved",           "reference orbit",
                          "refuted", "median error", "largest error", "under another law"};
  for (const auto& [varied, variation] : variations_of(evaluation.results())) {
    if (variation.values.size() < kFewestValues) continue;
    for (const std::string& value : variation.values) {
      const auto& [counts, errors] = results_of(variation.results.at(value));
      if (counts.cases == 0) continue;
      section.table.rows.push_back({varied.first, varied.second, value,
                                    count_cell(counts.solved, counts.own_law()),
                                    count_cell(counts.same_orbit), count_cell(counts.refuted),
                                    errors.empty() ? Cell("-") : error_cell(median(errors)),
                                    errors.empty() ? Cell("-") : error_cell(std::ranges::max(errors)),
                                    count_cell(counts.solved_under_another_law())});
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
                                 gain ? gain_cell(*gain) : Cell("none")};
      });
    }
    const OutcomeCounts off = results_of(results.at("false")).counts,
                        on = results_of(results.at("true")).counts;
    std::vector<Cell> row{varied.first, varied.second, count_cell(on.cases), count_cell(off.solved),
                          count_cell(on.solved)};
    if (gains.empty()) {
      row.insert(row.end(), 3, Cell("none"));
    } else {
      const auto [least, largest] = std::minmax_element(gains.begin(), gains.end());
      for (const double gain : {*least, median(gains), *largest}) row.push_back(gain_cell(gain));
    }
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

}  // namespace signorini
