// Methods that are commands and tell their own time: what passes beside it.

#include <fmt/format.h>

#include <utility>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/hand_over.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

constexpr std::string_view kHandOverText =
    R"(Methods that are commands and tell the time of their own computation, by
which they stand in all other tables. Hand-over is what passes beside it for every solve: the problem is written
and the answer read, the least of a round. Medians over the cases that were timed.)";

}  // namespace

Sections hand_over_sections(const Evaluation& evaluation) {
  Section section{
      .id = "hand-over", .title = "Commands: own time and hand-over", .text = std::string(kHandOverText)};
  section.table.header = {"method", "cases", "own time", "hand-over", "hand-over / own time"};
  for (const HandOver& one : hand_overs(evaluation)) {
    const Cell ratio = one.own > 0.0 ? Cell(fmt::format("{:.2g}", one.beside / one.own), one.beside / one.own)
                                     : Cell("-", 0.0);
    section.table.rows.push_back({one.configuration, count_cell(one.cases), Cell(time_text(one.own), one.own),
                                  Cell(time_text(one.beside), one.beside), ratio});
  }
  return {std::move(section)};
}

}  // namespace signorini
