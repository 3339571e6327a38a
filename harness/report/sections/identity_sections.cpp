// Methods that solve the same equations: one result each, however many rows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/evaluation/work_precision.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr std::string_view kText = R"(The methods of a row solve the same equations where their options are
equal: their rows are one result, not two that confirm each other. Where impacts are closed the way to it is one
and the same, too, and which of them is faster says nothing. Differences are relative, of the errors of x, over
the cases that both solve on the same orbit.)";

/// Whether every option that both runs have has the same value.
bool have_equal_options(const CaseChoice& a, const CaseChoice& b) {
  return std::ranges::all_of(a.options, [&](const auto& option) {
    const auto other = std::ranges::find(b.options, option.first, &RecordedOptions::value_type::first);
    return other == b.options.end() || other->second == option.second;
  });
}

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

Cell difference_cell(const Pairs& pairs, double difference) {
  if (pairs.differences.empty()) return {"none to compare", kNeverReached};
  return {fmt::format("{:.1e}", difference), difference};
}

}  // namespace

Sections identity_sections(const Evaluation& evaluation) {
  std::map<std::pair<std::string, std::string>, Pairs> found;  // by configuration
  for (const CaseResult& a : evaluation.results()) {
    const std::string& same = a.choice->same_equations_as;
    if (same.empty() || a.outcome.status == Status::not_applicable) continue;
    for (const CaseResult& b : evaluation.results_of(a.scene->name)) {
      if (b.choice->method == same && have_equal_options(*a.choice, *b.choice))
        compare(a, b, found[{a.choice->configuration, b.choice->configuration}]);
    }
  }
  Section section{.id = "equal-equations", .title = "Equal equations"};
  section.text = kText;
  section.table.header = {"method",
                          "same equations as",
                          "cases",
                          "solved by one alone",
                          "on two orbits",
                          "median difference",
                          "largest difference"};
  for (const auto& [methods, pairs] : found) {
    const auto& d = pairs.differences;
    section.table.rows.push_back({methods.first, methods.second, count_cell(pairs.cases),
                                  count_cell(pairs.one_alone), count_cell(pairs.other_orbits),
                                  difference_cell(pairs, d.empty() ? 0.0 : median(d)),
                                  difference_cell(pairs, d.empty() ? 0.0 : std::ranges::max(d))});
  }
  return {std::move(section)};
}

}  // namespace signorini
