#include "harness/report/page/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/page/html.hpp"
#include "harness/report/page/packed.hpp"
#include "harness/report/page/page_figures.hpp"
#include "harness/report/page/page_parts.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

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

/// What a manifest says of the run, as a definition list.
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
  return facts.empty() ? "<p>The run has no manifest.</p>\n" : "<dl>" + facts + "</dl>\n";
}

/// Everything that the script needs: names, records, figures.
Json data_of(const Evaluation& evaluation, std::span<const Section> sections) {
  Json data{{"configurations", evaluation.configurations()}, {"cases", Json::array()}};
  for (const Record& record : evaluation.records()) {
    data["cases"].push_back(record.case_id);
    data["records"].push_back(printed(record));
  }
  for (const std::string& scene : evaluation.scenes()) {
    data["scenes"][scene] = {{"work", work_precision_data(evaluation, scene)},
                             {"motion", motion_data(evaluation, scene)},
                             {"schematic", schematic_data(evaluation, scene)}};
  }
  for (const Section& section : sections)
    if (const auto group = group_of(section))
      data["profiles"][std::to_string(*group)] = profile_data(evaluation, *group);
  return data;
}

std::string head_of(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
      "form-action 'none'; img-src data:; style-src 'unsafe-inline'; script-src {} {}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{} - signorini</title>\n<style>\n{}</style></head>\n",
      script_source(kChartLibrary), script_source(kPageScript), html_escaped(title), kPageStyle);
}

constexpr const char* kEnd = R"(</main>
<dialog id="record" aria-labelledby="record-title"><h2 id="record-title"></h2><p id="record-facts"></p>
<pre tabindex="0" aria-label="The record as it is kept"></pre><button type="button">Close</button></dialog>
<div id="hint" aria-hidden="true" hidden></div>
)";

}  // namespace

std::string html_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                      std::span<const Section> sections) {
  const Json data = data_of(evaluation, sections);
  std::string text = head_of(title) + "<body>\n<a class=\"skip\" href=\"#main\">Skip to the content</a>\n" +
                     navigation(evaluation, sections) + "<main id=\"main\" tabindex=\"-1\">\n";
  text += fmt::format(
      "<header><p class=\"brand\">signorini</p><h1>{}</h1>\n<p>{}</p></header>\n"
      "<noscript><p class=\"note\">Figures and records need JavaScript here; all tables are complete without "
      "it. The records are in records.jsonl beside this page.</p></noscript>\n",
      html_escaped(title), html_escaped(counts_line(evaluation)));
  text += verdict_of(evaluation) + side_by_side(evaluation);
  for (const Section* section : of_kinds(sections, {SectionKind::overview})) text += section_of(*section);
  text += "<h2>Scene by scene</h2>\n";
  for (const std::string& scene : evaluation.scenes())
    text += scene_of(scene, evaluation, sections, data["scenes"][scene]);
  for (const Section* section :
       of_kinds(sections, {SectionKind::scenes, SectionKind::cases, SectionKind::remarks}))
    text += section_of(*section);
  text += "<section id=\"about\"><h2>How this run was made</h2>\n" + facts_of(manifest);
  for (const Section* section : of_kinds(sections, {SectionKind::origin})) text += section_of(*section, "h3");
  text += "</section>\n" + std::string(kEnd);
  return text + fmt::format(
                    "<script type=\"application/octet-stream\" id=\"data\">{}</script>\n"
                    "<script>{}</script>\n<script>{}</script>\n</body></html>\n",
                    packed(data.dump(-1, ' ', false, Json::error_handler_t::replace)), kChartLibrary,
                    kPageScript);
}

}  // namespace signorini
