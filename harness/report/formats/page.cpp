#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/formats/html.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// Sections that come before the scenes; the long tables come after them.
bool is_overview(const Section& section) {
  return section.kind == SectionKind::overview || section.kind == SectionKind::scenes;
}

std::string navigation(std::span<const Section> sections, std::span<const SceneFigures> scenes) {
  std::string text = "<nav><p class=\"brand\">signorini</p>\n<ul>\n";
  const auto item = [](const std::string& target, const std::string& title) {
    return fmt::format("<li><a href=\"#{}\">{}</a></li>\n", html_escaped(target), html_escaped(title));
  };
  const auto short_title = [](const Section& section) {
    // Of two groups' sections the first names the matter.
    return section.title.substr(0, section.title.find(':'));
  };
  std::string last;
  for (const Section& section : sections) {
    const std::string title = short_title(section);
    if (title != last) text += item(section.id, title);
    last = title;
  }
  text += item("records", "Records") + "</ul>\n<p>Scenes</p>\n<ul class=\"scenes\">\n";
  for (const SceneFigures& scene : scenes) text += item("scene-" + scene.scene, scene.scene);
  return text + "</ul></nav>\n";
}

std::string figures_of(const std::vector<Figure>& figures, const std::map<std::string, std::string>& svgs) {
  std::string text;
  for (const Figure& figure : figures) {
    if (const auto svg = svgs.find(figure.name); svg != svgs.end()) text += html_figure(figure, svg->second);
  }
  return text.empty() ? text : "<div class=\"figures\">\n" + text + "</div>\n";
}

std::string section_of(const Section& section, const std::map<std::string, std::string>& svgs) {
  std::string text = fmt::format("<section id=\"{}\"><h2>{}</h2>\n", section.id, html_escaped(section.title));
  if (!section.text.empty()) text += fmt::format("<p>{}</p>\n", html_text(section.text));
  text += figures_of(section.figures, svgs) + html_table(section.table);
  if (!section.note.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", html_text(section.note));
  return text + "</section>\n";
}

/// The orbit reached from rest, from the first record that found it.
std::string orbit_facts(const Evaluation& evaluation, const std::string& scene) {
  const auto& records = evaluation.records();
  const auto found = std::find_if(records.begin(), records.end(), [&](const Record& record) {
    return record.scene == scene && record.law_matches_scene == true && record.certificate.same_orbit == true;
  });
  if (found == records.end()) return "No record of the orbit reached from rest.";
  const Certificate& orbit = found->certificate;
  std::string text = fmt::format("The orbit reached from rest, {}", orbit.orbit.value_or("unnamed"));
  if (found->period) text += fmt::format(", repeats after {:.6g} s", *found->period);
  text += fmt::format("; events per period: {}", orbit.events.size());
  if (orbit.stable) text += *orbit.stable ? "; stable" : "; unstable";
  if (orbit.error_bar) text += fmt::format("; known to {:.1e}", *orbit.error_bar);
  return text + ".";
}

std::string law_of_scene(const Evaluation& evaluation, const std::string& scene) {
  for (const Record& record : evaluation.records()) {
    if (record.scene == scene && record.scene_law) return law_text(*record.scene_law);
  }
  return "not recorded";
}

/// The rows of a section that belong to a scene, its first column left out.
void add_rows_of_scene(const Section& section, const std::string& scene, Table& table) {
  if (table.header.empty()) table.header.assign(section.table.header.begin() + 1, section.table.header.end());
  for (const auto& row : section.table.rows) {
    if (row.front().text == scene) table.rows.emplace_back(row.begin() + 1, row.end());
  }
}

std::string scene_of(const SceneFigures& scene, const Evaluation& evaluation,
                     std::span<const Section> sections, const std::map<std::string, std::string>& svgs) {
  Table laws;
  for (const Section& section : sections) {
    if (section.kind == SectionKind::scenes) add_rows_of_scene(section, scene.scene, laws);
  }
  return fmt::format(
             "<section class=\"scene\" id=\"scene-{0}\"><h2>{0}</h2>\n<p>The scene's law: {1}. {2} The "
             "table: the "
             "law that each method represents, how many of its resolutions are solved, and the time to "
             "error; "
             "<a href=\"#cases\" data-filter=\"{0}\">all runs on this scene</a>.</p>\n",
             html_escaped(scene.scene), html_escaped(law_of_scene(evaluation, scene.scene)),
             html_escaped(orbit_facts(evaluation, scene.scene))) +
         html_table(laws) + figures_of(scene.figures, svgs) + "</section>\n";
}

/// One key a line; motions are left to the figures.
std::string printed(const Record& record) {
  Json json = to_json(record);
  json.erase("waveforms");
  std::string text = "{\n";
  for (const auto& [key, value] : json.items()) {
    text += fmt::format("  \"{}\": {},\n", key, json_line(value));
  }
  text.erase(text.size() - 2, 1);  // the last comma
  return text + "}";
}

std::string records_of(const Evaluation& evaluation) {
  std::string text = "<section id=\"records\"><h2>Records</h2>\n<p>Each run as it was recorded.</p>\n";
  for (const Record& record : evaluation.records()) {
    text += fmt::format("<details id=\"{}\"><summary>{}</summary><pre>{}</pre></details>\n",
                        record_anchor(evaluation.place_of(record)), html_escaped(record.case_id),
                        html_escaped(printed(record)));
  }
  return text + "</section>\n";
}

/// What a manifest says of the run, as entries of a definition list.
std::string facts_of(const Json& manifest) {
  std::string facts;
  const auto add = [&](const char* name, const char* pointer) {
    const Json::json_pointer place{pointer};
    if (!manifest.contains(place)) return;
    const Json& value = manifest[place];
    facts += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", html_escaped(name),
                         html_escaped(value.is_string() ? value.get<std::string>() : value.dump()));
  };
  add("suite", "/suite");
  add("date", "/date");
  add("commit", "/build/commit");
  add("compiler", "/build/compiler");
  add("flags", "/build/flags");
  add("processor", "/machine/cpu");
  add("processors", "/machine/processors");
  add("time limit [s]", "/limits/timeout_s");
  return facts;
}

std::string header_of(const std::string& title, const Json& manifest, const Evaluation& evaluation) {
  std::string text = fmt::format("<header><h1>{}</h1>\n<p>{} runs: {} methods on {} scenes.</p>\n<dl>",
                                 html_escaped(title), evaluation.records().size(),
                                 evaluation.configurations().size(), evaluation.scenes().size());
  return text + facts_of(manifest) + "</dl></header>\n";
}

}  // namespace

std::string html_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                      std::span<const Section> sections, std::span<const SceneFigures> scenes,
                      const std::map<std::string, std::string>& svgs) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
      "dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{} - "
      "signorini</title>\n<style>\n{}</style></head>\n<body>\n",
      html_escaped(title), kPageStyle);
  text += navigation(sections, scenes) + "<main>\n" + header_of(title, manifest, evaluation);
  for (const Section& section : sections) {
    if (is_overview(section)) text += section_of(section, svgs);
  }
  for (const SceneFigures& scene : scenes) text += scene_of(scene, evaluation, sections, svgs);
  for (const Section& section : sections) {
    if (!is_overview(section)) text += section_of(section, svgs);
  }
  text += records_of(evaluation);
  return text + fmt::format("</main>\n<script>\n{}</script>\n</body></html>\n", kPageScript);
}

}  // namespace signorini
