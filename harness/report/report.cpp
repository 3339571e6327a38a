#include "harness/report/report.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "harness/records/manifest_check.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

std::vector<SceneFigures> figures_by_scene(const Evaluation& evaluation) {
  std::vector<SceneFigures> scenes;
  for (const std::string& scene : evaluation.scenes()) {
    SceneFigures& figures =
        scenes.emplace_back(SceneFigures{scene, work_precision_figures(evaluation, scene)});
    for (Figure& figure : motion_figures(evaluation, scene)) figures.figures.push_back(std::move(figure));
  }
  return scenes;
}

/// Draws every figure and reads it back, by name.
std::map<std::string, std::string> draw_all(const fs::path& folder, const std::vector<Section>& sections,
                                            const std::vector<SceneFigures>& scenes) {
  std::vector<Figure> figures;
  for (const Section& section : sections)
    figures.insert(figures.end(), section.figures.begin(), section.figures.end());
  for (const SceneFigures& scene : scenes)
    figures.insert(figures.end(), scene.figures.begin(), scene.figures.end());
  draw_figures(folder, figures);
  std::map<std::string, std::string> svgs;
  for (const Figure& figure : figures) svgs[figure.name] = read_file(folder / (figure.name + ".svg"));
  return svgs;
}

/// Null where there is none.
nlohmann::ordered_json manifest_in(const fs::path& folder) {
  const fs::path file = folder / "manifest.json";
  return fs::exists(file) ? read_manifest(file) : nlohmann::ordered_json();
}

}  // namespace

std::vector<fs::path> write_report(const fs::path& folder, const Evaluation& evaluation,
                                   const std::vector<std::string>& formats) {
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
  if (!wants("tex") && !wants("html")) return files;
  const std::vector<SceneFigures> scenes = figures_by_scene(evaluation);
  const std::map<std::string, std::string> svgs = draw_all(folder / "figures", sections, scenes);
  if (wants("tex")) {
    fs::create_directories(folder / "tables");
    for (const Section& section : sections)
      write(folder / "tables" / (section.id + ".tex"), to_latex(section));
  }
  if (wants("html")) {
    write(folder / "report.html",
          html_page(run_name(folder), manifest_in(folder), evaluation, sections, scenes, svgs));
  }
  return files;
}

std::vector<Section> document_sections(const std::string& run, const Evaluation& evaluation) {
  std::vector<Section> sections = sections_of(evaluation);
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
