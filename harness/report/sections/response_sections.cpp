// How much of the exact frequency responses each method finds.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "harness/records/record_json.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

Cell percent_cell(std::optional<double> share) {
  if (!share) return "-";
  return {fmt::format("{:.1f} %", 100.0 * *share), *share};
}

Cell error_cell(std::optional<double> error) { return number_cell(error, "{:.1e}"); }

/// The fastest curve of the method that the exact responses are made by.
const ResponseStanding* reference_of(const ResponseGroup& group) {
  const ResponseStanding* reference = nullptr;
  for (const ResponseStanding& one : group.standings)
    if (one.makes_the_exact && one.cost && (reference == nullptr || *one.cost < *reference->cost))
      reference = &one;
  return reference;
}

Section verdict_section(std::span<const ResponseGroup> groups) {
  Section section{.id = "response-verdict",
                  .title = "Which method for whole frequency responses",
                  .text = std::string(kResponseRule) + " Its time stands in the last column.",
                  .note =
                      "`found` is the share of the exact branches' length within 2 % of the method's, "
                      "`false` the share of the method's own that is farther than 5 % from every motion of "
                      "the scene; time is that of the processor per unit of right length."};
  section.table.header = {
      "responses", "method", "found", "false", "time per length", "reference", "reference, time per length"};
  for (const ResponseGroup& group : groups) {
    const auto best = std::ranges::find_if(group.standings, &ResponseStanding::recommended);
    std::vector<Cell>& row = section.table.rows.emplace_back();
    row.emplace_back(group_title(group));
    if (group.is_too_small())
      row.insert(row.end(), {std::string(kTooFewScenes), "-", "-", "-"});
    else if (best == group.standings.end())
      row.insert(row.end(), 4, "-");
    else
      row.insert(row.end(), {best->label, percent_cell(best->found), percent_cell(best->false_share),
                             time_cell(best->cost)});
    const ResponseStanding* const reference = group.is_too_small() ? nullptr : reference_of(group);
    row.emplace_back(reference == nullptr ? "-" : reference->label);
    row.push_back(time_cell(reference == nullptr ? std::nullopt : reference->cost));
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
          "contact that it located itself, with the largest error of their frequency, `invented` those that "
          "are not there; time is that of the processor, per unit of right length."};
  section.table.header = {"scenes",  "method",        "responses", "found", "false",
                          "located", "largest error", "invented",  "time",  "time per length"};
  for (const ResponseGroup& group : groups) {
    for (const ResponseStanding& one : group.standings)
      section.table.rows.push_back({std::string(group.kind ? kind_title(*group.kind) : "Unrecorded law"),
                                    one.label + (one.makes_the_exact ? " (the reference)" : ""),
                                    count_cell(one.followed, one.asked), percent_cell(one.found),
                                    percent_cell(one.false_share), count_cell(one.located, one.points),
                                    error_cell(one.largest_error), count_cell(one.invented),
                                    time_cell(one.seconds), time_cell(one.cost)});
  }
  return section;
}

/// \param place  of the record in the report, where one of its cells leads
std::vector<Cell> case_row(const Record& record, std::size_t place) {
  const RecordedResponse& response = *record.response;
  std::vector<Cell> row{record.scene, response_label(record), law_remark(record)};
  if (!response.comparison) {
    row.emplace_back(std::string(status_name(record.status))).record = place;
    row.insert(row.end(), 7, "-");
    row.emplace_back(record.message);
    return row;
  }
  const CurveComparison& c = *response.comparison;
  row.push_back(count_cell(response.points));
  row.emplace_back(percent_cell(c.close.covered)).record = place;
  row.insert(row.end(), {percent_cell(c.close.covered_stable), percent_cell(c.wide.covered),
                         percent_cell(c.wide.false_share),
                         count_cell(located_points(c), std::ssize(c.points)), error_cell(largest_error(c)),
                         time_cell(record.seconds ? Measure(record.seconds->median) : Measure()),
                         joined(response.open_ends, "; ")});
  return row;
}

Section case_section(const Evaluation& evaluation) {
  Section section{.id = "response-cases",
                  .kind = SectionKind::responses,
                  .title = "Each response",
                  .text =
                      "`found` within 2 %, of the stable part alone, of all orders, and within 5 %; `false` "
                      "beyond 5 % of every motion of the scene. `other law`: the method represents that law "
                      "instead of the scene's, and its branches count in no sum."};
  section.table.header = {"scene",        "method", "other law", "points",        "found", "found, stable",
                          "found in 5 %", "false",  "located",   "largest error", "time",  "left open"};
  const std::span<const Record> records = evaluation.responses();
  for (std::size_t i = 0; i < records.size(); ++i)
    if (!is_exact(records[i]))
      section.table.rows.push_back(case_row(records[i], evaluation.place_of_response(i)));
  return section;
}

/// How far off a method located a point, with the law where it represents another one than the scene's.
Cell located_cell(const Record& record, std::size_t point) {
  const std::vector<PointMatch>& points = record.response->comparison->points;
  const std::optional<double> error = point < points.size() ? error_of(points[point]) : std::nullopt;
  const std::string remark = law_remark(record);
  Cell cell = error_cell(error);
  if (error && !remark.empty()) cell.text += fmt::format(" ({})", remark);
  return cell;
}

Section located_section(const Evaluation& evaluation) {
  Section section{
      .id = "located",
      .kind = SectionKind::responses,
      .title = "Folds, doublings and beginnings of contact",
      .text =
          "Where they are on the exact branches, and the relative error of the frequency at which a method "
          "located each, with the law in parentheses where it represents another one; `-` where it did not."};
  const std::vector<std::string> methods = response_labels(evaluation.responses());
  section.table.header = {"scene", "point", "order", "omega [rad/s]"};
  section.table.header.insert(section.table.header.end(), methods.begin(), methods.end());
  std::map<std::string, std::map<std::string, const Record*>> by_scene;
  for (const Record& record : evaluation.responses())
    if (record.response->comparison) by_scene[record.scene][response_label(record)] = &record;
  for (const auto& [scene, of_methods] : by_scene) {
    const CurveComparison& first = *of_methods.begin()->second->response->comparison;
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      const LocatedPoint& exact = first.points[i].exact;
      std::vector<Cell> row{scene, std::string(enum_name(exact.kind)), count_cell(exact.order),
                            Cell(fmt::format("{:.10g}", exact.frequency), exact.frequency)};
      for (const std::string& method : methods) {
        const auto found = of_methods.find(method);
        row.push_back(found == of_methods.end() ? Cell("-") : located_cell(*found->second, i));
      }
      section.table.rows.push_back(std::move(row));
    }
  }
  return section;
}

Section open_section(const Evaluation& evaluation) {
  Section section{
      .id = "open-ends",
      .kind = SectionKind::responses,
      .title = "The exact responses, and where they are not known to be whole",
      .text =
          "A method is measured against the branches that are known: those of motions of up to six periods "
          "of the load on scenes of at most ten coordinates, of up to the order asked for on others. They "
          "begin at answers, at orbits of one impact, and at the motions that starts settle to; orbits found "
          "by steps that lie on none of them count too."};
  section.table.header = {"scene", "from", "to", "orders", "branches", "points", "left open"};
  for (const Record& record : evaluation.responses()) {
    if (!is_exact(record)) continue;
    const RecordedResponse& response = *record.response;
    std::vector<std::string> open = response.open_ends;
    if (!record.message.empty()) open.push_back(record.message);
    section.table.rows.push_back({record.scene, fmt::format("{:.6g}", response.question.from),
                                  fmt::format("{:.6g}", response.question.to),
                                  count_cell(response.question.orders),
                                  count_cell(std::ssize(response.branches)), count_cell(response.points),
                                  open.empty() ? "nothing" : joined(open, "; ")});
  }
  return section;
}

}  // namespace

Sections response_sections(const Evaluation& evaluation) {
  if (evaluation.responses().empty()) return {};
  const std::vector<ResponseGroup> groups = response_groups(evaluation.responses());
  return {verdict_section(groups), overview_section(groups), case_section(evaluation),
          located_section(evaluation), open_section(evaluation)};
}

}  // namespace signorini
