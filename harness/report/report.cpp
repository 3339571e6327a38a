#include "harness/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/page/page.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/run_folder.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// The figures of a scene as gnuplot draws them.
std::vector<Figure> figures_of(const Evaluation& evaluation, const std::string& scene, Column column) {
  std::vector<Figure> figures = work_precision_figures(evaluation, scene, column);
  if (Figure figure = convergence_figure(evaluation, scene, column); !figure.data.empty())
    figures.push_back(std::move(figure));
  for (Figure& figure : option_figures(evaluation, scene, column)) figures.push_back(std::move(figure));
  for (Figure& figure : motion_figures(evaluation, scene, column)) figures.push_back(std::move(figure));
  return figures;
}

/// Draws every figure of a run, of many scenes those of some at a time.
void draw_all_figures(const fs::path& folder, const Evaluation& evaluation,
                      const std::vector<Section>& sections, Column column) {
  constexpr std::size_t kAtATime = 500;
  std::vector<Figure> figures;
  for (const Section& section : sections)
    if (const auto group = group_of(section))
      for (const auto& draw : {profile_figure, distribution_figure})
        figures.push_back(draw(evaluation, *group, column));
  for (const std::string& scene : evaluation.scenes()) {
    std::ranges::move(figures_of(evaluation, scene, column), std::back_inserter(figures));
    if (figures.size() < kAtATime) continue;
    draw_figures(folder, figures);
    figures.clear();
  }
  std::ranges::move(response_figures(evaluation, column), std::back_inserter(figures));
  draw_figures(folder, figures);
}

/// The manifest; null where there is none.
nlohmann::ordered_json manifest_in(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  return fs::exists(file) ? read_manifest(file) : nlohmann::ordered_json();
}

/// Writes report.html, and where the cases are too many for one page, pages/NUMBER.html, one part of the run
/// in memory at a time.
void write_pages(const fs::path& folder, const Evaluation& evaluation, const std::vector<Section>& sections) {
  const std::string title = run_name(folder);
  const nlohmann::ordered_json manifest = manifest_in(folder);
  std::error_code failure;
  fs::remove_all(folder / "pages", failure);  // of a report of more cases
  if (evaluation.results().size() <= kMostOfPage)
    return write_whole(folder / "report.html", html_page(title, manifest, evaluation, sections));
  folder_inside(folder, "pages");
  const std::vector<PagePart> parts = page_parts(evaluation);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<Record> records;
    for (const CaseResult& result : parts[i].results) records.push_back(evaluation.record_of(result));
    const Evaluation part(std::move(records), {.timeout = evaluation.time_limit()});
    write_whole(folder / parts[i].file, part_page(title, manifest, part, parts, i));
  }
  write_whole(folder / "report.html", overview_page(title, manifest, evaluation, sections, parts));
}

/// The methods that are recommended for each kind of scene, with the median time to each error, how many of
/// the motions with at most 10 % are stable, and what decides.
Section verdict_section(const Evaluation& evaluation) {
  Section section{.id = "verdict", .title = "Which method?"};
  section.table.header = {"scenes", "method"};
  for (const char* error : kErrorTitles) section.table.header.push_back(fmt::format("to {}", error));
  section.table.header.insert(section.table.header.end(), {"stability", "reason"});
  const auto add_words = [&](std::string first, std::string second) {
    section.table.rows.push_back({std::move(first), std::move(second), "-", "-", "-", "-", "-", "-"});
  };
  for (const SceneGroup& group : scene_groups(evaluation)) {
    const auto scenes = std::ssize(group.scenes);
    const std::string title = fmt::format("{}, {}", kind_title(group.kind), plural(scenes, "scene"));
    if (group.is_too_small()) add_words(title, std::string(kTooFewScenes));
    for (const Standing& standing : group.standings) {
      if (!standing.recommended) continue;
      std::vector<Cell> row{title, standing.names()};
      for (const Reach& reach : standing.reach) {
        const double seconds = reach.median_seconds();
        row.emplace_back(fmt::format("{}{} of {}", std::isfinite(seconds) ? time_text(seconds) + ", " : "",
                                     reach.scenes, scenes));
      }
      const Reach& certified = standing.reach.front();
      row.emplace_back(stability_text(certified.stable, certified.unstable, certified.scenes));
      row.emplace_back(standing.reason);
      section.table.rows.push_back(std::move(row));
    }
  }
  if (!evaluation.times_remark().empty()) add_words("All", evaluation.times_remark());
  return section;
}

// What somebody reads: where all tables together are too long, the first rows of each long one.
std::string short_markdown(const std::vector<Section>& sections) {
  constexpr std::size_t kMost = 300'000, kMostOfTable = 8'000;  // characters
  std::string whole = markdown_report(sections);
  return whole.size() > kMost ? markdown_report(sections, kMostOfTable) : whole;
}

}  // namespace

std::vector<fs::path> write_report(const fs::path& folder, const Evaluation& evaluation,
                                   const std::vector<std::string>& formats, Column column) {
  const auto wants = [&](const char* format) { return std::ranges::count(formats, format) > 0; };
  const bool tables = wants("md") || wants("whole") || wants("tex") || wants("html");
  const std::vector<Section> sections = tables ? sections_of(evaluation) : std::vector<Section>();
  std::vector<fs::path> files;
  const auto write = [&](const fs::path& file, const auto& text) {
    write_whole(file, text);
    files.push_back(file);
  };
  if (wants("md")) write(folder / "table.md", short_markdown(sections));
  if (wants("whole")) write(folder / "table-whole.md", markdown_report(sections));
  if (wants("csv") && !evaluation.results().empty()) {
    write(folder / "table.csv", [&](const TextSink& sink) { csv_report(evaluation, sink); });
    write(folder / "measures.csv", [&](const TextSink& sink) { measures_csv(evaluation, sink); });
  }
  if (wants("tex")) {
    draw_all_figures(folder / "figures", evaluation, sections, column);
    const fs::path tables = folder_inside(folder, "tables");
    for (const Section& section : sections) write(tables / (section.id + ".tex"), to_latex(section));
  }
  if (wants("html")) {
    write_pages(folder, evaluation, sections);
    files.push_back(folder / "report.html");
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
