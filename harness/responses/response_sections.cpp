#include "harness/responses/response_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/formats/screen_groups.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

Cell percent_cell(std::optional<double> share) {
  if (!share) return "-";
  return {fmt::format("{:.1f} %", 100.0 * *share), *share};
}

Cell seconds_cell(std::optional<double> seconds) {
  return seconds ? Cell(time_text(*seconds), *seconds) : Cell("-");
}

Cell error_cell(std::optional<double> error) {
  return error ? Cell(fmt::format("{:.1e}", *error), *error) : Cell("-");
}

constexpr const char* kNothingCompared = "No method was compared with an exact response.";

/// The names and figures of a standing, or dashes.
void add_standing(std::vector<Cell>& row, const ResponseStanding* standing) {
  if (standing == nullptr) {
    row.insert(row.end(), {"-", "-", "-", "-"});
    return;
  }
  row.insert(row.end(), {standing->label, percent_cell(standing->found), percent_cell(standing->false_share),
                         seconds_cell(standing->cost)});
}

const ResponseStanding* recommended_of(const ResponseGroup& group) {
  const auto found = std::ranges::find_if(group.standings, &ResponseStanding::recommended);
  return found == group.standings.end() ? nullptr : &*found;
}

/// The best of those that the exact responses are not made by, where that is another.
const ResponseStanding* other_of(const ResponseGroup& group) {
  const auto found = std::ranges::find_if(group.standings, [](const ResponseStanding& one) {
    return one.recommended_otherwise && !one.recommended;
  });
  return found == group.standings.end() ? nullptr : &*found;
}

Section verdict_section(std::span<const ResponseGroup> groups) {
  Section section{.id = "verdict",
                  .title = "Which method for whole frequency responses",
                  .text = std::string(kResponseRule) +
                          " The exact responses are made by exact-orbit with shorter steps; the best of the "
                          "other methods stands beside it.",
                  .note =
                      "`found` is the share of the exact branches' length within 2 % of the method's, "
                      "`false` the share of the method's own that is farther than 5 % from every exact one; "
                      "time is that of the processor per unit of right length."};
  section.table.header = {"responses",    "method",          "found",
                          "false",        "time per length", "best other",
                          "other, found", "other, false",    "other, time per length"};
  if (groups.empty()) section.text = kNothingCompared;
  for (const ResponseGroup& group : groups) {
    std::vector<Cell>& row = section.table.rows.emplace_back();
    row.emplace_back(group_title(group));
    add_standing(row, recommended_of(group));
    add_standing(row, other_of(group));
  }
  return section;
}

Section overview_section(std::span<const ResponseGroup> groups) {
  Section section{
      .id = "responses",
      .title = "How much of the exact frequency responses each method finds",
      .text =
          "By kinds of scenes, for the methods that represent their law, sums of length: `found` is the "
          "share of the exact branches within 2 % of the method's, `false` that of the method's own branches "
          "that is farther than 5 % from every exact one; `located` are folds, doublings and beginnings of "
          "contact that it located itself, with the largest error of their frequency, `invented` those "
          "that are not there; time is that of the processor, per unit of right length."};
  section.table.header = {"scenes",  "method",        "responses", "found", "false",
                          "located", "largest error", "invented",  "time",  "time per length"};
  for (const ResponseGroup& group : groups) {
    for (const ResponseStanding& one : group.standings)
      section.table.rows.push_back({std::string(group.kind ? kind_title(*group.kind) : "Unrecorded law"),
                                    one.label, count_cell(one.followed, one.asked), percent_cell(one.found),
                                    percent_cell(one.false_share), count_cell(one.located, one.points),
                                    error_cell(one.largest_error), count_cell(one.invented),
                                    seconds_cell(one.seconds), seconds_cell(one.cost)});
  }
  return section;
}

/// The law that a method represents where it is not the scene's.
Cell other_law_cell(const ResponseRecord& record) {
  return of_another_law(record) && record.law ? law_text(*record.law) : std::string();
}

Cell leading_to(Cell cell, std::size_t place) {
  cell.record = place;
  return cell;
}

/// \param place  of the record among all, where its cells lead
std::vector<Cell> case_row(const ResponseRecord& record, std::size_t place) {
  if (!record.comparison) {
    const Cell status = leading_to(std::string(status_name(record.status)), place);
    return {record.scene, label_of(record), other_law_cell(record), status, "-", "-", "-", "-", "-", "-",
            "-",          record.message};
  }
  const CurveComparison& c = *record.comparison;
  return {record.scene,
          label_of(record),
          other_law_cell(record),
          count_cell(record.points),
          leading_to(percent_cell(c.close.covered), place),
          percent_cell(c.close.covered_stable),
          percent_cell(c.wide.covered),
          percent_cell(c.wide.false_share),
          count_cell(located_points(c), std::ssize(c.points)),
          error_cell(largest_error(c)),
          seconds_cell(record.seconds),
          joined(record.open_ends, "; ")};
}

Section case_section(std::span<const ResponseRecord> records) {
  Section section{.id = "response-cases",
                  .kind = SectionKind::scenes,
                  .title = "Each response",
                  .text =
                      "`found` within 2 %, of the stable part alone, and within 5 %; `false` beyond 5 %. "
                      "`other law`: the method represents that law instead of the scene's, and its branches "
                      "count in no sum."};
  section.table.header = {"scene",        "method", "other law", "points",        "found", "found, stable",
                          "found in 5 %", "false",  "located",   "largest error", "time",  "left open"};
  for (std::size_t place = 0; place < records.size(); ++place)
    if (!is_exact(records[place])) section.table.rows.push_back(case_row(records[place], place));
  return section;
}

Section located_section(std::span<const ResponseRecord> records) {
  Section section{.id = "located",
                  .kind = SectionKind::scenes,
                  .title = "Folds, doublings and beginnings of contact",
                  .text =
                      "Where they are on the exact branches, and the relative error of the frequency at "
                      "which a method located each; `-` where it did not."};
  const std::vector<std::string> methods = labels_of(records);
  section.table.header = {"scene", "point", "order", "omega [rad/s]"};
  section.table.header.insert(section.table.header.end(), methods.begin(), methods.end());
  std::map<std::string, std::map<std::string, const ResponseRecord*>> by_scene;
  for (const ResponseRecord& record : records)
    if (record.comparison) by_scene[record.scene][label_of(record)] = &record;
  for (const auto& [scene, of_methods] : by_scene) {
    const CurveComparison& first = *of_methods.begin()->second->comparison;
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      const LocatedPoint& exact = first.points[i].exact;
      std::vector<Cell> row{scene, describe(exact.kind), count_cell(exact.order),
                            Cell(fmt::format("{:.10g}", exact.frequency), exact.frequency)};
      for (const std::string& method : methods) {
        const auto found = of_methods.find(method);
        const bool has = found != of_methods.end() && i < found->second->comparison->points.size();
        row.push_back(has ? error_cell(error_of(found->second->comparison->points[i])) : Cell("-"));
      }
      section.table.rows.push_back(std::move(row));
    }
  }
  return section;
}

Section open_section(std::span<const ResponseRecord> records) {
  Section section{
      .id = "open-ends",
      .kind = SectionKind::scenes,
      .title = "The exact responses, and where they are not known to be whole",
      .text =
          "A method is measured against what is known, up to the orders looked for: branches that "
          "hang together with the answers at both ends of the interval, and orbits found in steps "
          "on none of them."};
  section.table.header = {"scene", "from", "to", "orders", "branches", "points", "left open"};
  for (const ResponseRecord& record : records) {
    if (!is_exact(record)) continue;
    std::vector<std::string> open = record.open_ends;
    if (!record.message.empty()) open.push_back(record.message);
    section.table.rows.push_back({record.scene, fmt::format("{:.6g}", record.from),
                                  fmt::format("{:.6g}", record.to), count_cell(record.orders),
                                  count_cell(static_cast<std::ptrdiff_t>(record.branches.size())),
                                  count_cell(record.points), open.empty() ? "nothing" : joined(open, "; ")});
  }
  return section;
}

}  // namespace

std::string response_screen(std::span<const ResponseRecord> records) {
  constexpr std::size_t kName = 42;
  constexpr std::size_t kRows = 28;  // of titles and methods together
  const std::vector<ResponseGroup> groups = response_groups(records);
  if (groups.empty()) return std::string(kNothingCompared) + "\n";
  const std::size_t most = std::max<std::size_t>(3, kRows / groups.size()) - 1;
  std::string text;
  const auto add = [&](std::string words) {
    for (const std::string& line : wrapped_lines(words, kScreenWidth)) text += line + "\n";
  };
  add("Which method? Share of the exact branches found, of its own false, special points located, "
      "processor time per length:");
  text += fmt::format("{:<44}{:>8}{:>8}{:>9}{:>10}\n", "", "found", "false", "located", "time");
  for (const ResponseGroup& group : groups) {
    text += group_title(group) + "\n";
    for (const ResponseStanding& one :
         std::span(group.standings).first(std::min(most, group.standings.size()))) {
      text += fmt::format("{} {:<{}}", one.recommended || one.recommended_otherwise ? "*" : " ",
                          clipped(one.label, kName), kName);
      text +=
          fmt::format("{:>6.1f} %{:>6.1f} %{:>9}{:>10}\n", 100.0 * one.found, 100.0 * one.false_share,
                      fmt::format("{}/{}", one.located, one.points), one.cost ? time_text(*one.cost) : "-");
    }
  }
  text += "\n";
  add(std::string(kResponseRule) +
      " The exact responses are made by exact-orbit with shorter steps: the best other has a star too.");
  return text;
}

std::vector<Section> response_sections(std::span<const ResponseRecord> records) {
  const std::vector<ResponseGroup> groups = response_groups(records);
  return {verdict_section(groups), overview_section(groups), case_section(records), located_section(records),
          open_section(records)};
}

}  // namespace signorini
