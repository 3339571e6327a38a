#include <fmt/format.h>

#include <algorithm>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/work_precision.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

/// Time of the cheapest run that reaches an error, and that run.
Cell reached_cell(const Evaluation& evaluation, const ResolutionStudy& study, double error) {
  const CurvePoint point = cost_to_error(study, time_axis(), error);
  if (point.run != nullptr)
    return {time_text(point.cost), point.cost, evaluation.place_of(*point.run->record)};
  const bool reached = std::any_of(study.runs.begin(), study.runs.end(),
                                   [&](const ScoredRun& run) { return run.error && *run.error <= error; });
  return {reached ? "not timed" : "not reached", kNeverReached};
}

std::vector<Cell> study_row(const Evaluation& evaluation, const ResolutionStudy& study) {
  const Record& first = *study.runs.front().record;
  const std::string law = first.law ? law_text(*first.law) : in_place(first);
  std::vector<Cell> row{study.scene, study.configuration, law,
                        count_cell(solved_runs(study), std::ssize(study.runs))};
  for (const double error : kErrorLevels) row.push_back(reached_cell(evaluation, study, error));
  return row;
}

Table study_table(const Evaluation& evaluation, bool another_law) {
  Table table{{"scene", "method", "represents", "solved"}, {}};
  for (const double error : kErrorLevels) table.header.push_back(fmt::format("{:.0e}", error));
  for (const ResolutionStudy& study : evaluation.studies()) {
    if ((study.eligibility == Eligibility::another_law) == another_law)
      table.rows.push_back(study_row(evaluation, study));
  }
  return table;
}

}  // namespace

Sections scene_sections(const Evaluation& evaluation) {
  return {{.id = "scenes",
           .kind = SectionKind::scenes,
           .title = "Time to error, scene by scene",
           .text =
               "The time of the cheapest run whose error is at most that of the column. Solved: resolutions "
               "whose answer is certified, and the orbit reached from rest.",
           .table = study_table(evaluation, false)}};
}

Sections other_law_sections(const Evaluation& evaluation) {
  return {{.id = "other-laws",
           .kind = SectionKind::scenes,
           .title = "Methods that represent another law",
           .text =
               "They solve another problem than the scene states: errors are those against the motion under "
               "their own law, and rank them against nobody above.",
           .table = study_table(evaluation, true)}};
}

}  // namespace signorini
