#include "harness/report/page/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/page/page_shell.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// The figures that the script draws of whole sections.
Json profiles_of(const Evaluation& evaluation, std::span<const Section> sections) {
  Json profiles;
  for (const Section& section : sections)
    if (const auto group = group_of(section))
      profiles[std::to_string(*group)] = profile_data(evaluation, *group);
  return profiles;
}

/// The responses of a run: names after those of motions, records after theirs, figures.
void add_responses(const Evaluation& evaluation, Json& data) {
  const std::vector<Record>& records = evaluation.responses();
  if (records.empty()) return;
  for (std::size_t i = 0; i < evaluation.configurations().size(); ++i) data["steps"].push_back(nullptr);
  for (const std::string& label : response_labels(records)) {
    data["configurations"].push_back(label);
    data["steps"].push_back(label.ends_with(" by steps"));
  }
  for (const Record& record : records) {
    Json json = to_json(record);
    json["response"].erase("branches");  // left to the figures
    data["cases"].push_back(record.case_id);
    data["records"].push_back(printed(json));
  }
  for (const std::string& scene : scenes_followed(evaluation))
    data["scenes"][scene]["response"] = response_data(evaluation, scene);
}

/// Everything that the script needs: names, records, figures.
Json data_of(const Evaluation& evaluation, std::span<const Section> sections) {
  Json data{{"configurations", evaluation.configurations()}, {"cases", Json::array()}};
  for (const CaseResult& result : evaluation.results()) {
    data["cases"].push_back(result.case_id);
    Json json = to_json(evaluation.record_of(result));
    json.erase("waveforms");  // left to the figures
    data["records"].push_back(printed(json));
  }
  for (const std::string& scene : evaluation.scenes()) {
    data["scenes"][scene] = {{"work", work_precision_data(evaluation, scene)},
                             {"motion", motion_data(evaluation, scene)},
                             {"schematic", schematic_data(evaluation, scene)}};
  }
  add_responses(evaluation, data);
  if (Json profiles = profiles_of(evaluation, sections); !profiles.is_null())
    data["profiles"] = std::move(profiles);
  return data;
}

std::string text_of(const std::vector<const Section*>& sections, const char* heading = "h2") {
  std::string text;
  for (const Section* section : sections) text += section_of(*section, heading);
  return text;
}

std::string origin_of(const Json& manifest, std::span<const Section> sections) {
  return about_section(manifest, text_of(of_kinds(sections, {SectionKind::origin}), "h3"));
}

/// "sdof-1 to sdof-9".
std::string scenes_of(const PagePart& part) {
  const std::string &first = part.scenes.front(), &last = part.scenes.back();
  return first == last ? first : first + " to " + last;
}

/// A list of links to all parts.
std::string list_of(std::span<const PagePart> parts) {
  std::string text = fmt::format(
      "<section id=\"cases\"><h2>Every scene and case</h2>\n<p>They are on {} pages, each with its scenes, "
      "cases and records. <code>table.csv</code> has all cases in one table.</p>\n<ol>\n",
      parts.size());
  for (const PagePart& part : parts) {
    text += fmt::format("<li><a href=\"{}\">{}</a>, {}</li>\n", part.file, html_escaped(scenes_of(part)),
                        plural(std::ssize(part.results), "case"));
  }
  return text + "</ol></section>\n";
}

/// Which method for motions, if the run has any.
std::string opening_of(const Evaluation& evaluation) {
  return shows_motions(evaluation) ? verdict_of(evaluation) + side_by_side(evaluation) : std::string();
}

/// The sections of responses whole. Names of methods lead to every case: without motions that is here.
std::string text_of_responses(const Evaluation& evaluation, std::span<const Section> sections) {
  std::string text;
  for (const Section* section : of_kinds(sections, {SectionKind::responses})) {
    Section shown = *section;
    if (!shows_motions(evaluation) && shown.id == "response-cases") shown.id = "cases";
    text += section_of(shown);
  }
  return text;
}

}  // namespace

std::string html_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                      std::span<const Section> sections, const std::string& links) {
  const Json data = data_of(evaluation, sections);
  std::string text = opening_of(evaluation) + text_of(of_kinds(sections, {SectionKind::overview})) +
                     "<h2>Scene by scene</h2>\n";
  for (const std::string& scene : evaluation.scenes())
    text += scene_of(scene, evaluation, sections, data["scenes"][scene]);
  for (const std::string& scene : scenes_followed(evaluation))
    text += response_of(scene, evaluation, sections, data["scenes"][scene]["response"]);
  text += text_of(of_kinds(sections, {SectionKind::scenes, SectionKind::cases, SectionKind::remarks})) +
          text_of_responses(evaluation, sections);
  return whole_page({.title = title,
                     .summary = html_escaped(counts_line(evaluation)) + links,
                     .contents = navigation(evaluation, sections),
                     .main = text + origin_of(manifest, sections)},
                    data);
}

std::vector<PagePart> page_parts(const Evaluation& evaluation, std::size_t most) {
  const std::span<const std::string> scenes = evaluation.scenes();
  const std::span<const CaseResult> results = evaluation.results();
  std::vector<PagePart> parts;
  std::size_t scene = 0, begin = 0;  // of the part
  for (std::size_t i = 0, end = 0; i < scenes.size(); ++i) {
    end += evaluation.results_of(scenes[i]).size();
    const bool last = i + 1 == scenes.size();
    const std::size_t next = last ? 0 : evaluation.results_of(scenes[i + 1]).size();
    if (!last && end - begin + next <= most) continue;
    parts.push_back({.file = fmt::format("pages/{:04}.html", parts.size() + 1),
                     .scenes = scenes.subspan(scene, i + 1 - scene),
                     .results = results.subspan(begin, end - begin)});
    scene = i + 1;
    begin = end;
  }
  return parts;
}

std::string overview_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                          std::span<const Section> sections, std::span<const PagePart> parts) {
  Json data{{"configurations", evaluation.configurations()}, {"cases", Json::array()}};
  data["profiles"] = profiles_of(evaluation, sections);
  const std::vector<const Section*> overviews = of_kinds(sections, {SectionKind::overview});
  return whole_page(
      {.title = title,
       .summary = html_escaped(counts_line(evaluation)),
       .contents = contents_of(
           list_part("", item("verdict", "Which method?") + item("cases", "Every scene and case")) +
           list_part("Over all scenes", section_items(overviews)) +
           list_part("", item("about", "How this run was made"))),
       .main = verdict_of(evaluation) + list_of(parts) + text_of(overviews) + origin_of(manifest, sections)},
      data);
}

std::string part_page(const std::string& title, const Json& manifest, const Evaluation& evaluation,
                      std::span<const PagePart> parts, std::size_t number) {
  const auto link = [&](std::size_t other, const char* word) {
    return fmt::format(" <a href=\"../{}\">{}</a>", parts[other].file, word);
  };
  std::string links = fmt::format(
      ". Page {} of {}: tables over all scenes are over those of this page. <a href=\"../report.html\">The "
      "whole run</a>",
      number + 1, parts.size());
  if (number > 0) links += link(number - 1, "previous");
  if (number + 1 < parts.size()) links += link(number + 1, "next");
  return html_page(fmt::format("{}, {}", title, scenes_of(parts[number])), manifest, evaluation,
                   sections_of(evaluation), links);
}

}  // namespace signorini
