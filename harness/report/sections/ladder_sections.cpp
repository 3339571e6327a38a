#include <fmt/format.h>

#include <algorithm>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/work_precision.hpp"

namespace signorini {

namespace {

/// How many of a ladder's runs are credited with an error.
Cell credited_cell(const Ladder& ladder) {
  const std::size_t credited = credited_rungs(ladder);
  return {fmt::format("{} of {}", credited, ladder.rungs.size()), static_cast<double>(credited)};
}

/// Time of the cheapest run that reaches an error, and that run.
Cell reached_cell(const Evaluation& evaluation, const Ladder& ladder, double error) {
  const CurvePoint point = cost_to_error(ladder, time_axis(), error);
  if (point.rung != nullptr)
    return {time_text(point.cost), point.cost, evaluation.place_of(*point.rung->record)};
  const bool reached = std::any_of(ladder.rungs.begin(), ladder.rungs.end(),
                                   [&](const Rung& rung) { return rung.error && *rung.error <= error; });
  return {reached ? "not timed" : "not reached", kNeverReached};
}

std::vector<Cell> ladder_row(const Evaluation& evaluation, const Ladder& ladder) {
  const Record& first = *ladder.rungs.front().record;
  const std::string law = first.law ? law_text(*first.law) : in_place(first);
  std::vector<Cell> row{ladder.scene, ladder.contestant, law, credited_cell(ladder)};
  for (const double error : kErrorLevels) row.push_back(reached_cell(evaluation, ladder, error));
  return row;
}

Table ladder_table(const Evaluation& evaluation, bool another_law) {
  Table table{{"scene", "method", "represents", "solved"}, {}};
  for (const double error : kErrorLevels) table.header.push_back(fmt::format("{:.0e}", error));
  for (const Ladder& ladder : evaluation.ladders()) {
    if ((ladder.standing == Standing::another_law) == another_law)
      table.rows.push_back(ladder_row(evaluation, ladder));
  }
  return table;
}

}  // namespace

std::vector<Section> scene_sections(const Evaluation& evaluation) {
  return {{.id = "scenes",
           .title = "Time to error, scene by scene",
           .text =
               "The time of the cheapest run whose error is at most that of the column. Solved: resolutions "
               "whose answer is certified, and the orbit reached from rest.",
           .table = ladder_table(evaluation, false)}};
}

std::vector<Section> other_law_sections(const Evaluation& evaluation) {
  return {{.id = "other-laws",
           .title = "Methods that represent another law",
           .text =
               "They solve another problem than the scene states: errors are those against the motion under "
               "their own law, and rank them against nobody above.",
           .table = ladder_table(evaluation, true)}};
}

}  // namespace signorini
