// Methods that solve the same equations: one result each, however many rows.

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/resolution_study.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"
#include "harness/text/words.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

namespace {

/// Cases of two methods with equal equations.
struct Pairs {
  int cases = 0, one_alone = 0, other_orbits = 0;
  std::vector<double> differences = {};  ///< relative, of the errors of x, where both have the same orbit
};

/// |a - b| / max(a, b) of the errors of two certified answers of one orbit.
void compare(const CaseResult& a, const CaseResult& b, Pairs& pairs) {
  ++pairs.cases;
  const Measure of_a = certified_error(a), of_b = certified_error(b);
  if (!of_a || !of_b) {
    pairs.one_alone += of_a || of_b ? 1 : 0;
  } else if (a.orbit != b.orbit) {
    ++pairs.other_orbits;
  } else {
    const double larger = std::max(*of_a, *of_b);
    pairs.differences.push_back(larger == 0.0 ? 0.0 : std::abs(*of_a - *of_b) / larger);
  }
}

using PairsByConfigurations = std::map<std::pair<std::string, std::string>, Pairs>;

/// Adds pairs of configurations that nothing is said of, with the same answers to the last bit on every
/// scene.
void add_equal_answers(const Evaluation& evaluation, PairsByConfigurations& found) {
  std::map<std::string, std::vector<const ResolutionStudy*>> by_configuration;
  for (const ResolutionStudy& study : evaluation.studies())
    by_configuration[study.configuration].push_back(&study);
  std::map<std::string, std::string> first;  // with these answers
  for (const auto& [configuration, studies] : by_configuration) {
    const std::string answers = answers_of(studies);
    if (answers.empty()) continue;
    const auto [place, fresh] = first.try_emplace(answers, configuration);
    if (fresh || found.contains({configuration, place->second}) ||
        found.contains({place->second, configuration}))
      continue;
    std::ptrdiff_t cases = 0;
    for (const ResolutionStudy* study : studies) cases += claimed_runs(*study);
    found[{configuration, place->second + " (same answers)"}] = {
        .cases = static_cast<int>(cases), .differences = std::vector(static_cast<std::size_t>(cases), 0.0)};
  }
}

}  // namespace

Sections identity_sections(const Evaluation& evaluation) {
  PairsByConfigurations found;
  for (const CaseResult& a : evaluation.results()) {
    if (a.choice->same_equations_as.empty() || a.outcome.status == Status::not_applicable) continue;
    for (const CaseResult& b : evaluation.results_of(a.scene->name)) {
      if (has_equations_of(*a.choice, *b.choice))
        compare(a, b, found[{a.choice->configuration, b.choice->configuration}]);
    }
  }
  add_equal_answers(evaluation, found);
  Section section{.id = "equal-equations", .title = "Equal equations"};
  section.text = R"(The methods of a row solve the same equations where their options are
equal: their rows are one result, not two that confirm each other. With impact closure they
also run the same algorithm: do not compare their times. Differences are relative, of the errors of x, over
the cases that both solve on the same orbit. Same answers: the methods give the same answers to the last bit in every
case, whatever they say of their equations.)";
  section.table.header = split(
      "method|same equations as|cases|solved by one alone|on two orbits|median difference|largest difference",
      '|');
  for (const auto& [methods, pairs] : found) {
    const std::vector<double>& d = pairs.differences;
    const auto difference = [&](const auto& of) {
      return number_cell(d.empty() ? Measure() : of(d), "{:.1e}", "none to compare");
    };
    section.table.rows.push_back({methods.first, methods.second, count_cell(pairs.cases),
                                  count_cell(pairs.one_alone), count_cell(pairs.other_orbits),
                                  difference(median), difference(std::ranges::max)});
  }
  return {std::move(section)};
}

Sections limit_sections(const Evaluation& evaluation) {
  Section section{.id = "limits", .title = "Limits of the methods"};
  section.text =
      "The laws of the stop that each method of this run can represent (`restitution`: a rigid stop, "
      "`penalty`: a spring, `massless`: contacts without mass), and what it cannot do. Options may change "
      "both: `signorini show METHOD`.";
  section.table.header = {"method", "laws", "limits"};
  for (const MethodEntry& entry : method_catalogue()) {
    const bool is_run = std::ranges::any_of(
        evaluation.results(), [&](const CaseResult& result) { return result.choice->method == entry.name; });
    if (is_run && !entry.limits.empty()) section.table.rows.push_back({entry.name, entry.laws, entry.limits});
  }
  return {std::move(section)};
}

}  // namespace signorini
