#include "harness/responses/response_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/formats/screen_groups.hpp"
#include "harness/sweep/branch_response.hpp"

namespace signorini {

namespace {

Cell percent_cell(std::optional<double> share) {
  if (!share) return "-";
  return {fmt::format("{:.1f} %", 100.0 * *share), *share};
}

Cell seconds_cell(std::optional<double> seconds) {
  return seconds ? Cell(time_text(*seconds), *seconds) : Cell("-");
}

/// Relative error of a located point.
std::optional<double> error_of(const PointMatch& match) {
  if (!match.frequency) return std::nullopt;
  return std::abs(*match.frequency - match.exact.frequency) / match.exact.frequency;
}

Cell error_cell(std::optional<double> error) {
  return error ? Cell(fmt::format("{:.1e}", *error), *error) : Cell("-");
}

std::ptrdiff_t found_points(const CurveComparison& comparison) {
  return std::ranges::count_if(comparison.points,
                               [](const PointMatch& m) { return m.frequency.has_value(); });
}

std::optional<double> largest_error(const CurveComparison& comparison) {
  std::optional<double> largest;
  for (const PointMatch& match : comparison.points) {
    if (const auto error = error_of(match)) largest = std::max(largest.value_or(0.0), *error);
  }
  return largest;
}

/// Sums over the responses of one method.
struct Totals {
  std::ptrdiff_t followed = 0, asked = 0, found = 0, points = 0, invented = 0;
  double exact = 0.0, covered = 0.0, length = 0.0, wrong = 0.0, right = 0.0, seconds = 0.0;
  std::optional<double> error = {};

  void add(const ResponseRecord& record) {
    if (record.status == Status::not_applicable) return;
    ++asked;
    if (record.status == Status::converged) ++followed;
    if (!record.comparison) return;
    const CurveComparison& c = *record.comparison;
    exact += c.exact_length;
    covered += c.close.covered * c.exact_length;
    length += c.length;
    wrong += c.wide.false_share * c.length;
    right += c.right_length;
    found += found_points(c);
    points += static_cast<std::ptrdiff_t>(c.points.size());
    invented += static_cast<std::ptrdiff_t>(c.invented.size());
    seconds += record.seconds.value_or(0.0);
    if (const auto largest = largest_error(c)) error = std::max(error.value_or(0.0), *largest);
  }
};

Totals totals_of(std::span<const ResponseRecord> records, const std::string& label) {
  Totals totals;
  for (const ResponseRecord& record : records)
    if (!is_exact(record) && label_of(record) == label) totals.add(record);
  return totals;
}

std::optional<double> length_share(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

/// Of the exact responses of all scenes, as far as any method was compared with them.
double exact_length_of(std::span<const ResponseRecord> records) {
  std::map<std::string, double> by_scene;
  for (const ResponseRecord& record : records)
    if (record.comparison) by_scene[record.scene] = record.comparison->exact_length;
  double sum = 0.0;
  for (const auto& [scene, length] : by_scene) sum += length;
  return sum;
}

/// By kResponseRule, of those that `asked` takes; null where none qualifies.
template <class Asked>
ResponseStanding* best_standing(std::vector<ResponseStanding>& standings, Asked asked) {
  constexpr double kMostFalse = 0.05, kAsMuch = 0.05;
  double most = 0.0;
  const auto qualifies = [&](const ResponseStanding& one) {
    return asked(one) && one.cost && one.false_share <= kMostFalse;
  };
  for (const ResponseStanding& one : standings)
    if (qualifies(one)) most = std::max(most, one.covered);
  ResponseStanding* best = nullptr;
  for (ResponseStanding& one : standings)
    if (qualifies(one) && one.covered > 0.0 && one.covered >= most - kAsMuch &&
        (best == nullptr || *one.cost < *best->cost))
      best = &one;
  return best;
}

bool is_truth(const ResponseStanding& standing) { return standing.label.starts_with(kFollowedByArcLength); }

std::string in_words(const ResponseStanding& standing) {
  return fmt::format("`{}` ({:.1f} % of the exact branches, {:.1f} % false, {} per length)", standing.label,
                     100.0 * standing.covered, 100.0 * standing.false_share, time_text(*standing.cost));
}

Section overview(std::span<const ResponseRecord> records) {
  Section section{
      .id = "responses",
      .title = "How much of the exact frequency responses each method finds",
      .text =
          "Over all responses that a method applies to, by length: `covered` is the share of the exact "
          "branches within 2 % of the method's, `false` the share of the method's own branches that is "
          "farther than 5 % from every exact one; `located` are folds, doublings and beginnings of "
          "contact that it located itself, with the largest error of their frequency, `invented` those "
          "that are not there; time is that of the processor, per unit of right length."};
  section.table.header = {"method",        "responses", "covered", "false",          "located",
                          "largest error", "invented",  "time",    "time per length"};
  for (const std::string& label : labels_of(records)) {
    const Totals totals = totals_of(records, label);
    section.table.rows.push_back({label, count_cell(totals.followed, totals.asked),
                                  percent_cell(length_share(totals.covered, totals.exact)),
                                  percent_cell(length_share(totals.wrong, totals.length)),
                                  count_cell(totals.found, totals.points), error_cell(totals.error),
                                  count_cell(totals.invented), seconds_cell(totals.seconds),
                                  seconds_cell(length_share(totals.seconds, totals.right))});
  }
  if (!records.empty()) section.note = response_verdict(records) + " " + std::string(kResponseRule);
  return section;
}

Cell leading_to(Cell cell, std::size_t place) {
  cell.record = place;
  return cell;
}

/// \param place  of the record among all, where its cells lead
std::vector<Cell> case_row(const ResponseRecord& record, std::size_t place) {
  if (!record.comparison) {
    const Cell status = leading_to(std::string(status_name(record.status)), place);
    return {record.scene, label_of(record), status, "-", "-", "-", "-", "-", "-", "-", record.message};
  }
  const CurveComparison& c = *record.comparison;
  return {record.scene,
          label_of(record),
          count_cell(record.points),
          leading_to(percent_cell(c.close.covered), place),
          percent_cell(c.close.covered_stable),
          percent_cell(c.wide.covered),
          percent_cell(c.wide.false_share),
          count_cell(found_points(c), static_cast<std::ptrdiff_t>(c.points.size())),
          error_cell(largest_error(c)),
          seconds_cell(record.seconds),
          fmt::format("{}", fmt::join(record.open_ends, "; "))};
}

Section case_section(std::span<const ResponseRecord> records) {
  Section section{.id = "response-cases",
                  .kind = SectionKind::scenes,
                  .title = "Each response",
                  .text = "`covered` within 2 %, its stable part alone, and within 5 %; `false` beyond 5 %."};
  section.table.header = {"scene", "method",  "points",        "covered", "covered, stable", "covered in 5 %",
                          "false", "located", "largest error", "time",    "left open"};
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
    section.table.rows.push_back(
        {record.scene, fmt::format("{:.6g}", record.from), fmt::format("{:.6g}", record.to),
         count_cell(record.orders), count_cell(static_cast<std::ptrdiff_t>(record.branches.size())),
         count_cell(record.points), open.empty() ? "nothing" : fmt::format("{}", fmt::join(open, "; "))});
  }
  return section;
}

}  // namespace

std::vector<ResponseStanding> response_standings(std::span<const ResponseRecord> records) {
  std::vector<ResponseStanding> standings;
  const double exact = exact_length_of(records);
  for (const std::string& label : labels_of(records)) {
    const Totals totals = totals_of(records, label);
    standings.push_back({.label = label,
                         .covered = length_share(totals.covered, exact).value_or(0.0),
                         .false_share = length_share(totals.wrong, totals.length).value_or(0.0),
                         .cost = length_share(totals.seconds, totals.right)});
  }
  if (ResponseStanding* best = best_standing(standings, [](const ResponseStanding&) { return true; }))
    best->recommended = true;
  if (ResponseStanding* other =
          best_standing(standings, [](const ResponseStanding& s) { return !is_truth(s); }))
    other->recommended_otherwise = true;
  return standings;
}

std::string response_verdict(std::span<const ResponseRecord> records) {
  const std::vector<ResponseStanding> standings = response_standings(records);
  const auto best = std::ranges::find_if(standings, &ResponseStanding::recommended);
  const auto other = std::ranges::find_if(standings, &ResponseStanding::recommended_otherwise);
  if (best == standings.end())
    return "No method finds any of the exact branches with at most 5 % false ones.";
  std::string text = "Take " + in_words(*best) + ".";
  if (other != standings.end() && other != best)
    text += fmt::format(
        " The exact responses are made by the same method with shorter steps; the best of the others is {}.",
        in_words(*other));
  return text;
}

std::string response_screen(std::span<const ResponseRecord> records) {
  constexpr std::size_t kName = 40;
  std::string text;
  const auto add = [&](std::string words) {
    std::erase(words, '`');
    for (const std::string& line : wrapped_lines(words, kScreenWidth)) text += line + "\n";
  };
  add(response_verdict(records));
  text += fmt::format("\n{:<42}{:>9}{:>9}{:>8}{:>12}\n", "", "found", "false", "located", "time/length");
  for (const ResponseStanding& one : response_standings(records)) {
    const Totals totals = totals_of(records, one.label);
    text += fmt::format("{} {}", one.recommended || one.recommended_otherwise ? "*" : " ", one.label);
    text += one.label.size() > kName ? "\n" + std::string(kName + 2, ' ')
                                     : std::string(kName - one.label.size(), ' ');
    text +=
        fmt::format("{:>7.1f} %{:>7.1f} %{:>8}{:>12}\n", 100.0 * one.covered, 100.0 * one.false_share,
                    fmt::format("{}/{}", totals.found, totals.points), one.cost ? time_text(*one.cost) : "-");
  }
  text += "\n";
  add(std::string(kResponseRule));
  return text;
}

std::vector<Section> response_sections(std::span<const ResponseRecord> records) {
  return {overview(records), case_section(records), located_section(records), open_section(records)};
}

}  // namespace signorini
