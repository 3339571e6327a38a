#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/outcome.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

/// Errors of x within which a level counts as solved: the motion is found, and found well [-].
constexpr std::array kSolvedWithin{1e-1, 1e-3};

/// Records of one configuration on one family, by severity.
using Levels = std::map<int, std::vector<const Record*>>;

/// Contestants by place on every family, families by name.
using Families = std::map<std::string, std::map<std::size_t, Levels>>;

Families families_of(const Evaluation& evaluation) {
  Families families;
  for (const Record& record : evaluation.records()) {
    if (!record.family) continue;
    families[record.family->family][evaluation.place_of(configuration_of(record))][record.family->severity]
        .push_back(&record);
  }
  return families;
}

/// The severest level up to which all are solved; how many are if later ones are too.
Cell breakdown_cell(const Levels& levels, double error) {
  // Certified within the error; which orbit it is does not matter here.
  const auto is_solved = [error](const Record* record) {
    const Measure found = certified_error(*record);
    return found && *found <= error;
  };
  int in_a_row = 0, solved = 0;
  bool another_law = false;
  const Record* last = nullptr;
  for (const auto& [severity, records] : levels) {
    for (const Record* record : records) another_law |= record->law_matches_scene == false;
    if (std::ranges::none_of(records, is_solved)) continue;
    ++solved;
    if (solved != severity) continue;
    ++in_a_row;
    last = records.front();
  }
  const int all = levels.begin()->second.front()->family->levels;
  std::string text = "none";
  if (in_a_row == all)
    text = "all";
  else if (last != nullptr)
    text = level_label(last->family->level);
  if (solved > in_a_row) text += fmt::format(" ({} of {})", solved, all);
  if (another_law) text += " ≠";
  return {text, static_cast<double>(in_a_row)};
}

/// A row for each family, a column for each configuration.
template <class MakeCell>
Table family_table(const Evaluation& evaluation, const Families& families, const MakeCell& cell_of) {
  Table table{.header = {"family"}, .rows = {}};
  for (const std::string& configuration : evaluation.configurations()) table.header.push_back(configuration);
  for (const auto& [family, configurations] : families) {
    std::vector<Cell> row{family};
    for (std::size_t place = 0; place < evaluation.configurations().size(); ++place) {
      const auto found = configurations.find(place);
      row.push_back(found == configurations.end() ? Cell("not run") : cell_of(found->second));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Section breakdown_section(const Evaluation& evaluation, const Families& families, double error) {
  Section section{.id = fmt::format("breakdown-{:.0e}", error),
                  .title = fmt::format("Severest level solved with an error of x within {:.0e}", error)};
  section.text =
      "Each family is driven from easy to impossible. A cell names the last of its levels that the method "
      "solves, at any of "
      "its resolutions, together with all easier ones; in brackets how many it solves if harder ones are "
      "among them. `≠`: "
      "the method represents another law than the scene, and is measured by its own.";
  section.table = family_table(evaluation, families,
                               [error](const Levels& levels) { return breakdown_cell(levels, error); });
  return section;
}

/// The parameter and the levels of each family.
Section parameter_section(const Evaluation& evaluation) {
  std::map<std::string, std::string> parameters;             // by family
  std::map<std::string, std::map<int, std::string>> labels;  // and severity
  for (const Record& record : evaluation.records()) {
    if (!record.family) continue;
    parameters[record.family->family] = record.family->parameter;
    labels[record.family->family][record.family->severity] = level_label(record.family->level);
  }
  Section section{.id = "families", .title = "Families"};
  section.table.header = {"family", "parameter", "levels, easiest first"};
  for (const auto& [family, parameter] : parameters) {
    std::vector<std::string> levels;
    for (const auto& [severity, label] : labels[family]) levels.push_back(label);
    section.table.rows.push_back({family, parameter, fmt::format("{}", fmt::join(levels, ", "))});
  }
  return section;
}

/// How often a method reports convergence, and how often the harness refutes it.
Section false_convergence_section(const Evaluation& evaluation) {
  std::vector<OutcomeCounts> counts(evaluation.configurations().size());
  for (const Record& record : evaluation.records()) {
    if (record.family) counts[evaluation.place_of(configuration_of(record))].add(record);
  }
  Section section{.id = "false-convergence", .title = "Claims of convergence on the families"};
  section.table.header = {"method", "runs", "says converged", "certified", "refuted", "false convergence"};
  for (std::size_t place = 0; place < counts.size(); ++place) {
    const OutcomeCounts& count = counts[place];
    if (count.applicable() == 0) continue;
    const double rate = count.claims() > 0 ? 100.0 * count.refuted / count.claims() : 0.0;
    section.table.rows.push_back({evaluation.configurations()[place], count_cell(count.applicable()),
                                  count_cell(count.claims()), count_cell(count.certified),
                                  count_cell(count.refuted), Cell(fmt::format("{:.1f} %", rate), rate)});
  }
  section.note =
      "Refuted: the orbit that the harness finds from the answer is farther away than half its norm, or the "
      "answer penetrates "
      "a rigid stop by more than half the amplitude. What is neither certified nor refuted has no orbit near "
      "it that the "
      "harness knows.";
  return section;
}

/// The largest estimate of a certified answer.
Cell condition_cell(const Levels& levels) {
  double largest = 0.0;
  for (const auto& [severity, records] : levels) {
    for (const Record* record : records) {
      if (claim_of(*record) == Claim::certified) largest = std::max(largest, record->condition.value_or(0.0));
    }
  }
  return largest > 0.0 ? Cell(fmt::format("{:.0e}", largest), largest) : Cell("none");
}

/// How ill-conditioned the equations become on the way, as far as answers go.
Section condition_section(const Evaluation& evaluation, const Families& families) {
  Section section{.id = "condition", .title = "Largest condition estimate of a certified answer"};
  section.text =
      "Of the linear system that a method solved last, in the 1-norm, scaled and preconditioned as the "
      "method "
      "does it, from Krylov steps a lower bound: the largest over the levels of a family on which its answer "
      "is certified. Compare down a column. Its logarithm tells how many digits the answer may have lost.";
  section.table = family_table(evaluation, families, condition_cell);
  return section;
}

}  // namespace

Sections breakdown_sections(const Evaluation& evaluation) {
  const Families families = families_of(evaluation);
  if (families.empty()) return {};
  Sections sections{parameter_section(evaluation)};
  for (const double error : kSolvedWithin) sections.push_back(breakdown_section(evaluation, families, error));
  sections.push_back(false_convergence_section(evaluation));
  sections.push_back(condition_section(evaluation, families));
  return sections;
}

}  // namespace signorini
