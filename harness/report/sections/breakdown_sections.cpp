#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Errors of x within which a level counts as solved: the motion is found, and found well [-].
constexpr std::array kSolvedWithin{1e-1, 1e-3};

/// One configuration on one family, by severity.
using Levels = std::map<int, const ResolutionStudy*>;

/// Contestants by place on every family, families by name.
using Families = std::map<std::string, std::map<std::size_t, Levels>>;

/// The family level of a study's scene; nothing where the scene is none of a family.
const std::optional<FamilyLevel>& level_of(const ResolutionStudy& study) {
  return study.runs.front().result->scene->family;
}

Families families_of(const Evaluation& evaluation) {
  Families families;
  for (const ResolutionStudy& study : evaluation.studies()) {
    if (const std::optional<FamilyLevel>& level = level_of(study))
      families[level->family][evaluation.place_of(study.configuration)][level->severity] = &study;
  }
  return families;
}

/// Levels of a family that state a problem of its own law, or of another; solved ones are certified within an
/// error.
struct LevelCount {
  int levels = 0, solved = 0;
  int in_a_row = 0;  ///< solved with all easier ones
  const ResolutionStudy* last = nullptr;

  void add(const ResolutionStudy& study, bool is_level_solved) {
    ++levels;
    if (!is_level_solved) return;
    ++solved;
    if (solved != levels) return;
    ++in_a_row;
    last = &study;
  }
};

/// "0.01 (3 of 5)": the severest level of the scene's law up to which all are solved; how many are if later
/// ones are too. Behind it "≠ 2 of 2": levels solved under another law, each problem once.
Cell breakdown_cell(const Evaluation& evaluation, const Levels& levels, double error) {
  LevelCount own, other;
  for (const auto& [severity, study] : levels) {
    const bool solved = std::ranges::any_of(
        study->runs, [error](const ScoredRun& run) { return run.error && *run.error <= error; });
    if (study->eligibility != Eligibility::another_law)
      own.add(*study, solved);
    else if (!evaluation.is_repeated(*study))
      other.add(*study, solved);
  }
  std::string text;
  if (own.levels > 0) {
    const bool all = own.in_a_row == level_of(*levels.begin()->second)->levels;
    text = all ? "all" : own.last != nullptr ? level_label(level_of(*own.last)->level) : "none";
    if (own.solved > own.in_a_row) text += fmt::format(" ({} of {})", own.solved, own.levels);
  }
  if (other.levels > 0)
    text += fmt::format("{}≠ {} of {}", text.empty() ? "" : ", ", other.solved, other.levels);
  else if (text.empty())
    text = "≠ counted elsewhere";
  return {text, static_cast<double>(own.in_a_row)};
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
  Section section{
      .id = fmt::format("breakdown-{:.0e}", error),
      .title = fmt::format("Severest level solved with errors of x and force within {:.0e}", error)};
  section.text =
      "Each family is driven from easy to impossible. A cell names the last of the levels whose law the "
      "method represents that it solves, at any of its resolutions, together with all easier ones; in "
      "brackets how many it solves if harder ones are among them. `≠`: levels whose scenes have another law "
      "than the method, of which it solves so many under its own; those that state the same problem to it "
      "count once.";
  section.table = family_table(
      evaluation, families, [&](const Levels& levels) { return breakdown_cell(evaluation, levels, error); });
  return section;
}

/// The parameter and the levels of each family.
Section parameter_section(const Evaluation& evaluation) {
  std::map<std::string, std::string> parameters;             // by family
  std::map<std::string, std::map<int, std::string>> labels;  // and severity
  for (const CaseResult& result : evaluation.results()) {
    const std::optional<FamilyLevel>& family = result.scene->family;
    if (!family) continue;
    parameters[family->family] = family->parameter;
    labels[family->family][family->severity] = level_label(family->level);
  }
  Section section{.id = "families", .title = "Families"};
  section.table.header = {"family", "parameter", "levels, easiest first"};
  for (const auto& [family, parameter] : parameters) {
    std::vector<std::string> levels;
    for (const auto& [severity, label] : labels[family]) levels.push_back(label);
    section.table.rows.push_back({family, parameter, joined(levels, ", ")});
  }
  return section;
}

/// The largest estimate of a certified answer.
Cell condition_cell(const Levels& levels) {
  double largest = 0.0;
  for (const auto& [severity, study] : levels) {
    for (const ScoredRun& run : study->runs) {
      if (claim_of(run.result->outcome) == Claim::certified)
        largest = std::max(largest, run.result->condition.value_or(0.0));
    }
  }
  return largest > 0.0 ? number_cell(largest, "{:.0e}") : Cell("none");
}

/// How ill-conditioned the equations become on the way, as far as answers go.
Section condition_section(const Evaluation& evaluation, const Families& families) {
  Section section{.id = "condition", .title = "Largest condition estimate of a certified answer"};
  section.text =
      "Of the linear system that a method solved last, in the 1-norm, scaled and preconditioned as the "
      "method does it, from Krylov steps a lower bound: the largest over the levels of a family on which its "
      "answer is certified. Compare down a column. Its logarithm tells how many digits the answer may have "
      "lost.";
  section.table = family_table(evaluation, families, condition_cell);
  return section;
}

}  // namespace

Sections breakdown_sections(const Evaluation& evaluation) {
  const Families families = families_of(evaluation);
  if (families.empty()) return {};
  Sections sections{parameter_section(evaluation)};
  for (const double error : kSolvedWithin) sections.push_back(breakdown_section(evaluation, families, error));
  sections.push_back(condition_section(evaluation, families));
  return sections;
}

}  // namespace signorini
