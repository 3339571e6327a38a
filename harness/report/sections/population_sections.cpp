// Scenes drawn from ranges are a sample: shares and rates of them have intervals of confidence.

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr std::string_view kPopulationText =
    R"(The scenes are drawn from ranges of their numbers. No method was tuned to
them, and another seed draws others. Solved: certified under the scene's own law. False: claims to have converged that
are refuted, of a thousand claims. In brackets the intervals of 95 % confidence of the shares of the whole population
that the ranges describe (Wilson's). Rows whose intervals overlap may differ by chance.)";

/// "92 of 100 (85 to 96 %)", or per thousand.
Cell share_cell(int count, int of, double unit, std::string_view sign) {
  if (of == 0) return Cell{"none"};
  const Interval share = proportion(count, of);
  return Cell{
      fmt::format("{} of {} ({:.3g} to {:.3g}{})", count, of, unit * share.low, unit * share.high, sign)};
}

}  // namespace

Sections population_sections(const Evaluation& evaluation) {
  std::vector<OutcomeCounts> counts(evaluation.configurations().size());
  std::set<std::string> drawn;
  for (const CaseResult& result : evaluation.results()) {
    if (!result.scene->instance) continue;
    drawn.insert(result.scene->name);
    counts[evaluation.place_of(result.choice->configuration)].add(result.outcome);
  }
  if (drawn.empty()) return {};
  Section section{.id = "population", .title = fmt::format("{} scenes drawn at random", drawn.size())};
  section.text = kPopulationText;
  section.table.header = {"method", "solved", "claims", "false claims, per thousand"};
  for (std::size_t place = 0; place < counts.size(); ++place) {
    const OutcomeCounts& n = counts[place];
    if (n.cases == 0) continue;
    section.table.rows.push_back({evaluation.configurations()[place],
                                  share_cell(n.solved, n.own_law(), 100.0, " %"), count_cell(n.claims()),
                                  share_cell(n.refuted, n.claims(), 1000.0, "")});
  }
  return {std::move(section)};
}

}  // namespace signorini
