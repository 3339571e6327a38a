#include "harness/responses/response_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "harness/files.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "harness/report/formats/formats.hpp"

namespace signorini {

namespace {

bool is_exact(const ResponseRecord& record) { return record.method.empty(); }

std::string label_of(const ResponseRecord& record) {
  return record.method + (record.by_steps ? " by steps" : "");
}

/// Labels of methods in the order of their first record.
std::vector<std::string> labels(std::span<const ResponseRecord> records) {
  std::vector<std::string> found;
  for (const ResponseRecord& record : records) {
    const std::string label = label_of(record);
    if (!is_exact(record) && std::ranges::find(found, label) == found.end()) found.push_back(label);
  }
  return found;
}

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
  for (const std::string& label : labels(records)) {
    Totals totals;
    for (const ResponseRecord& record : records)
      if (!is_exact(record) && label_of(record) == label) totals.add(record);
    const auto share = [](double part, double whole) {
      return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
    };
    section.table.rows.push_back(
        {label, count_cell(totals.followed, totals.asked), percent_cell(share(totals.covered, totals.exact)),
         percent_cell(share(totals.wrong, totals.length)), count_cell(totals.found, totals.points),
         error_cell(totals.error), count_cell(totals.invented), seconds_cell(totals.seconds),
         seconds_cell(share(totals.seconds, totals.right))});
  }
  return section;
}

std::vector<Cell> case_row(const ResponseRecord& record) {
  if (!record.comparison) {
    return {
        record.scene, label_of(record), std::string(status_name(record.status)), "-", "-", "-", "-", "-", "-",
        "-",          record.message};
  }
  const CurveComparison& c = *record.comparison;
  return {record.scene,
          label_of(record),
          count_cell(record.points),
          percent_cell(c.close.covered),
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
  for (const ResponseRecord& record : records)
    if (!is_exact(record)) section.table.rows.push_back(case_row(record));
  return section;
}

Section located_section(std::span<const ResponseRecord> records) {
  Section section{.id = "located",
                  .kind = SectionKind::scenes,
                  .title = "Folds, doublings and beginnings of contact",
                  .text =
                      "Where they are on the exact branches, and the relative error of the frequency at "
                      "which a method located each; `-` where it did not."};
  const std::vector<std::string> methods = labels(records);
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
  Section section{.id = "open-ends",
                  .kind = SectionKind::scenes,
                  .title = "The exact responses, and where they are not known to be whole",
                  .text =
                      "A method is measured against what is known: branches that hang together with the "
                      "answers at both ends of the interval, up to the orders looked for."};
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

/// The parts of branches that are stable, or are not, as lines with gaps between them.
std::string lines_of(const std::vector<DrawnBranch>& branches, bool stable) {
  std::string lines;
  for (const DrawnBranch& branch : branches) {
    bool drawing = false;
    for (std::size_t i = 0; i < branch.frequency.size(); ++i) {
      // A piece belongs to the kind of its first point, so that the kinds meet.
      const bool here = (branch.stable[i] == 1) == stable;
      const bool before = i > 0 && (branch.stable[i - 1] == 1) == stable;
      if (here || before)
        lines += fmt::format("{:.8g} {:.6g}\n", branch.frequency[i], branch.amplitude[i]);
      else if (drawing)
        lines += "\n";
      drawing = here || before;
    }
    if (drawing) lines += "\n";
  }
  return lines;
}

/// All branches, with gaps between them.
std::string lines_of(const std::vector<DrawnBranch>& branches) {
  std::string lines;
  for (const DrawnBranch& branch : branches) {
    for (std::size_t i = 0; i < branch.frequency.size(); ++i)
      lines += fmt::format("{:.8g} {:.6g}\n", branch.frequency[i], branch.amplitude[i]);
    lines += "\n";
  }
  return lines;
}

constexpr int kPanelColumns = 3;

// Of 3 columns; sizes in cm.
constexpr double kPanelWidth = 6.0, kPanelHeight = 4.6;

constexpr std::string_view kResponsePanels =
    R"(set multiplot layout {},{} margins 0.07,0.99,{:.4f},{:.4f} spacing 0.05,{:.4f}
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror
set logscale y
set format y '10^{{%T}}'
set tics font ',8'
set title font ',8' offset 0,-0.6
set label 1 'amplitude [m] over frequency of the load [rad/s]; grey: exact, dashed where unstable; blue: by arc length; orange: by steps' at screen 0.5,{:.4f} center font ',8'
set xrange [{:.8g}:{:.8g}]
unset key
)";

/// The method's own branches, or the points of its steps, over the exact ones.
std::string panel(const ResponseRecord& record, std::optional<int> stable, std::optional<int> unstable,
                  Canvas& canvas) {
  canvas.plot(stable, "with lines lc rgb '#bbbbbb' lw 4");
  canvas.plot(unstable, "with lines lc rgb '#bbbbbb' lw 2 dt (8,6)");
  canvas.draw(lines_of(record.branches), record.by_steps ? "with points lc rgb '#D55E00' pt 6 ps 0.3"
                                                         : "with lines lc rgb '#0072B2' lw 1");
  return fmt::format("set title {} noenhanced\n{}", gnuplot_string(label_of(record)), canvas.panel());
}

Figure response_figure(const ResponseRecord& exact, std::span<const ResponseRecord> records) {
  Canvas canvas;
  const auto stable = canvas.add(lines_of(exact.branches, true));
  const auto unstable = canvas.add(lines_of(exact.branches, false));
  std::string panels;
  int count = 0;
  for (const ResponseRecord& record : records) {
    if (is_exact(record) || record.scene != exact.scene || record.branches.empty()) continue;
    panels += panel(record, stable, unstable, canvas);
    if (count++ == 0) panels += "unset label 1\n";  // once is enough
  }
  const int rows = std::max(1, (count + kPanelColumns - 1) / kPanelColumns);
  const double height = rows * kPanelHeight;
  // Room for titles and numbers, in shares of the figure.
  const double bottom = 1.3 / height, top = 1.0 - 0.8 / height, between = 1.4 / height;
  const double caption = 0.4 / height;
  return {.name = exact.scene + "-response",
          .caption = "Amplitude over the frequency of the load, " + exact.scene +
                     ": exact branches grey, unstable parts dashed; curves by arc length blue, steps orange",
          .script = fmt::format(kResponsePanels, rows, kPanelColumns, bottom, top, between, caption,
                                std::min(exact.from, exact.to), std::max(exact.from, exact.to)) +
                    panels + "unset multiplot\n",
          .data = canvas.data(),
          .width = kPanelColumns * kPanelWidth,
          .height = height};
}

}  // namespace

std::vector<Section> response_sections(std::span<const ResponseRecord> records) {
  return {overview(records), case_section(records), located_section(records), open_section(records)};
}

std::vector<Figure> response_figures(std::span<const ResponseRecord> records) {
  std::vector<Figure> figures;
  for (const ResponseRecord& record : records) {
    const bool followed = std::ranges::any_of(records, [&](const ResponseRecord& other) {
      return !is_exact(other) && other.scene == record.scene && !other.branches.empty();
    });
    if (is_exact(record) && !record.branches.empty() && followed)
      figures.push_back(response_figure(record, records));
  }
  return figures;
}

std::vector<std::filesystem::path> write_response_report(const std::filesystem::path& folder,
                                                         std::span<const ResponseRecord> records,
                                                         bool with_figures) {
  write_whole(folder / "table.md", markdown_report(response_sections(records)));
  std::vector<std::filesystem::path> files{folder / "table.md"};
  if (!with_figures) return files;
  const std::vector<Figure> figures = response_figures(records);
  draw_figures(folder / "figures", figures);
  for (const Figure& figure : figures) files.push_back(folder / "figures" / (figure.name + ".svg"));
  return files;
}

void write_response_tables_into(const std::filesystem::path& document, const std::filesystem::path& folder,
                                std::span<const ResponseRecord> records) {
  write_whole(document, with_tables(read_file(document), run_name(folder), response_sections(records)));
}

}  // namespace signorini
