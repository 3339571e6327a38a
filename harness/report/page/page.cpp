#include "harness/report/page/page.hpp"

#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/page/html.hpp"
#include "harness/report/page/page_figures.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/page/page_shell.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// Everything that the script needs: names, records, figures.
Json data_of(const Evaluation& evaluation, std::span<const Section> sections) {
  Json data{{"configurations", evaluation.configurations()}, {"cases", Json::array()}};
  for (const Record& record : evaluation.records()) {
    data["cases"].push_back(record.case_id);
    Json json = to_json(record);
    json.erase("waveforms");  // left to the figures
    data["records"].push_back(printed(json));
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

}  // namespace

std::string html_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                      std::span<const Section> sections) {
  const Json data = data_of(evaluation, sections);
  std::string text = verdict_of(evaluation) + side_by_side(evaluation);
  for (const Section* section : of_kinds(sections, {SectionKind::overview})) text += section_of(*section);
  text += "<h2>Scene by scene</h2>\n";
  for (const std::string& scene : evaluation.scenes())
    text += scene_of(scene, evaluation, sections, data["scenes"][scene]);
  for (const Section* section :
       of_kinds(sections, {SectionKind::scenes, SectionKind::cases, SectionKind::remarks}))
    text += section_of(*section);
  std::string origin;
  for (const Section* section : of_kinds(sections, {SectionKind::origin}))
    origin += section_of(*section, "h3");
  return whole_page({.title = title,
                     .summary = html_escaped(counts_line(evaluation)),
                     .contents = navigation(evaluation, sections),
                     .main = text + about_section(manifest, origin)},
                    data);
}

}  // namespace signorini
