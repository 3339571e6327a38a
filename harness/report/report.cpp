#include "harness/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "harness/records/manifest_check.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/formats/screen_groups.hpp"
#include "harness/report/page/page.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Every figure of a run as gnuplot draws it.
std::vector<Figure> figures_of(const Evaluation& evaluation, const std::vector<Section>& sections,
                               Column column) {
  std::vector<Figure> figures;
  for (const Section& section : sections)
    if (const auto group = group_of(section)) figures.push_back(profile_figure(evaluation, *group, column));
  for (const std::string& scene : evaluation.scenes()) {
    for (Figure& figure : work_precision_figures(evaluation, scene, column))
      figures.push_back(std::move(figure));
    if (Figure figure = convergence_figure(evaluation, scene, column); !figure.data.empty())
      figures.push_back(std::move(figure));
    for (Figure& figure : motion_figures(evaluation, scene, column)) figures.push_back(std::move(figure));
  }
  return figures;
}

/// The methods that are recommended for each kind of scene, with the median time to each error.
Section verdict_section(const Evaluation& evaluation) {
  Section section{.id = "verdict", .title = "Which method?"};
  section.table.header = {"scenes", "method"};
  for (const char* error : kErrorTitles) section.table.header.push_back(fmt::format("to {}", error));
  for (const SceneGroup& group : scene_groups(evaluation)) {
    const auto scenes = std::ssize(group.scenes);
    for (const Standing& standing : group.standings) {
      if (!standing.recommended) continue;
      std::vector<Cell> row{fmt::format("{}, {}", kind_title(group.kind), plural(scenes, "scene")),
                            standing.configuration};
      for (const Reach& reach : standing.reach) {
        const double seconds = reach.median_seconds();
        row.emplace_back(fmt::format("{}{} of {}", std::isfinite(seconds) ? time_text(seconds) + ", " : "",
                                     reach.scenes, scenes));
      }
      section.table.rows.push_back(std::move(row));
    }
  }
  return section;
}

/// Null where there is none.
nlohmann::ordered_json manifest_in(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  return fs::exists(file) ? read_manifest(file) : nlohmann::ordered_json();
}

}  // namespace

std::vector<fs::path> write_report(const fs::path& folder, const Evaluation& evaluation,
                                   const std::vector<std::string>& formats, Column column) {
  const auto wants = [&](const char* format) { return std::ranges::count(formats, format) > 0; };
  const std::vector<Section> sections = sections_of(evaluation);
  std::vector<fs::path> files;
  const auto write = [&](const fs::path& file, const std::string& text) {
    write_whole(file, text);
    files.push_back(file);
  };
  if (wants("md")) write(folder / "table.md", markdown_report(sections));
  if (wants("csv")) {
    write(folder / "table.csv", csv_report(evaluation));
    write(folder / "measures.csv", measures_csv(evaluation));
  }
  if (wants("tex")) {
    draw_figures(folder / "figures", figures_of(evaluation, sections, column));
    fs::create_directories(folder / "tables");
    for (const Section& section : sections)
      write(folder / "tables" / (section.id + ".tex"), to_latex(section));
  }
  if (wants("html")) {
    write(folder / "report.html", html_page(run_name(folder), manifest_in(folder), evaluation, sections));
  }
  return files;
}

std::vector<Section> document_sections(const std::string& run, const Evaluation& evaluation) {
  std::vector<Section> sections = sections_of(evaluation);
  sections.push_back(verdict_section(evaluation));
  sections.push_back(
      {.id = "screen",
       .text = screen_report(evaluation, {.folder = "results/" + run, .program = "signorini"})});
  return sections;
}

void write_tables_into(const fs::path& document, const fs::path& folder, const Evaluation& evaluation) {
  write_whole(document, with_tables(read_file(document), run_name(folder),
                                    document_sections(run_name(folder), evaluation)));
}

}  // namespace signorini
