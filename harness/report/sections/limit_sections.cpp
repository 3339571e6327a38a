// What the methods of a run cannot do, as their classes state it.

#include <algorithm>
#include <utility>

#include "harness/report/sections/sections.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

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
