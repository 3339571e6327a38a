#include "harness/report/page/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/report/page/page_shell.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// One method's row of a verdict: the median time to each error, and on how many scenes; how many of these
/// motions are unstable.
std::string standing_row(const Standing& standing) {
  std::string names = link_to_cases(standing.configuration);
  for (const std::string& other : standing.same) names += " = " + link_to_cases(other);
  std::string text = fmt::format(
      "<tr{0}><th scope=\"row\">{1}{2}</th>", standing.recommended ? " class=\"best\"" : "",
      standing.recommended ? "<span aria-hidden=\"true\">* </span><span class=\"unseen\">recommended: </span>"
                           : "",
      names);
  for (const Reach& reach : standing.reach) {
    const double seconds = reach.median_seconds();
    text += std::isfinite(seconds)
                ? fmt::format("<td class=\"n\" data-v=\"{:.6g}\">{} <small>{}</small></td>", seconds,
                              with_unit_signs(time_text(seconds)), reach.scenes)
                : fmt::format("<td class=\"n\">- <small>{}</small></td>", reach.scenes);
  }
  return text + fmt::format("<td class=\"n\">{}</td></tr>\n", standing.reach.front().unstable);
}

/// The orbit reached from rest, from the first record that found it.
std::string orbit_facts(const Evaluation& evaluation, const std::string& scene) {
  const std::span<const CaseResult> results = evaluation.results_of(scene);
  const auto found = std::ranges::find_if(results, [](const CaseResult& result) {
    return result.outcome.law_matches_scene == true && result.outcome.same_orbit == true;
  });
  if (found == results.end()) return "No record of the orbit reached from rest.";
  const Record record = evaluation.record_of(*found);
  const Certificate& orbit = record.certificate;
  std::string text = fmt::format("The orbit reached from rest, {}", orbit.orbit.value_or("unnamed"));
  if (record.period) text += fmt::format(", repeats after {:.6g} s", *record.period);
  text += fmt::format("; events per period: {}", orbit.events.size());
  const std::string stability = stability_words(orbit.stable, orbit.undefined);
  if (!stability.empty()) text += (orbit.stable ? "; " : "; stability ") + stability;
  if (orbit.error_bar) text += fmt::format("; known to {:.1e}", *orbit.error_bar);
  return text + ".";
}

std::string law_of_scene(const Evaluation& evaluation, const std::string& scene) {
  for (const CaseResult& result : evaluation.results_of(scene))
    if (result.scene->law) return law_text(*result.scene->law);
  return "not recorded";
}

/// The figures of a scene for which there are data.
std::string charts_of(const std::string& scene, const Json& data) {
  std::string text;
  const Json& work = data["work"];
  if (!work.is_null() && !work["own"].empty()) {
    text += chart("work", scene, "Error against time, " + scene,
                  "Error of x against time of set-up and solve. Each mark is a resolution and leads to its "
                  "record. Hollow marks: error too small to measure (below ten error bars of the orbit).");
  }
  if (!data["motion"].is_null()) {
    const int contact = data["motion"]["contact"];
    text += chart("waveforms", scene, "Motion over a period, " + scene,
                  fmt::format("One period at contact {}: the coarsest solved resolution of each method on "
                              "the certified orbit, which is the broad grey line. Dashed: the stop. Impacts "
                              "are jumps of the impulse; forces push the structure back: they are negative.",
                              contact));
    text += chart("portrait", scene, "Phase portrait, " + scene,
                  fmt::format("The same motions at contact {}, with the stop as a wall.", contact));
  }
  if (!work.is_null() && !work["other"].empty()) {
    text += chart("other", scene, "Error against time under other laws, " + scene,
                  "The same of methods that represent another law than the scene's: errors against the "
                  "motion under their own.");
  }
  return text.empty() ? text : kMethodSwitches + ("<div class=\"figures\">\n" + text) + "</div>\n";
}

}  // namespace

std::vector<const Section*> of_kinds(std::span<const Section> sections,
                                     std::initializer_list<SectionKind> kinds) {
  std::vector<const Section*> chosen;
  for (const Section& section : sections)
    if (std::ranges::find(kinds, section.kind) != kinds.end()) chosen.push_back(&section);
  return chosen;
}

Table rows_of_scene(std::span<const Section> sections, const std::string& id, const std::string& scene,
                    const std::vector<std::string>& columns) {
  Table table;
  const auto section = std::ranges::find(sections, id, &Section::id);
  if (section == sections.end()) return table;
  const std::vector<std::string>& header = section->table.header;
  table.header = columns.empty() ? std::vector(header.begin() + 1, header.end()) : columns;
  for (const std::vector<Cell>& row : section->table.rows) {
    if (row.front().text != scene) continue;
    std::vector<Cell>& kept = table.rows.emplace_back();
    for (const std::string& column : table.header)
      kept.push_back(row[static_cast<std::size_t>(std::ranges::find(header, column) - header.begin())]);
  }
  return table;
}

std::optional<std::size_t> group_of(const Section& section) {
  constexpr std::string_view kMeans = "means-";
  if (!section.id.starts_with(kMeans)) return std::nullopt;
  return std::stoul(section.id.substr(kMeans.size())) - 1;
}

std::string navigation(const Evaluation& evaluation, std::span<const Section> sections) {
  std::string scenes, responses;
  for (const std::string& scene : evaluation.scenes()) scenes += item("scene-" + scene, scene);
  for (const std::string& scene : scenes_followed(evaluation))
    responses += item(response_anchor(evaluation, scene), scene);
  const bool motions = shows_motions(evaluation);
  const std::string whole_responses =
      motions             ? section_items(of_kinds(sections, {SectionKind::responses}))
      : responses.empty() ? ""
                          : item("cases", "Each response") + item("open-ends", "The exact responses");
  return contents_of(
      list_part(
          "", motions ? item("verdict", "Which method?") + item("side-by-side", "Scenes side by side") : "") +
      list_part("Over all scenes", section_items(of_kinds(sections, {SectionKind::overview}))) +
      list_part("Scenes", scenes) + list_part("Responses", responses + whole_responses) +
      list_part("Run by run", section_items(of_kinds(sections, {SectionKind::scenes, SectionKind::cases,
                                                                SectionKind::remarks}))) +
      list_part("", item("about", "How this run was made")));
}

std::string verdict_of(const Evaluation& evaluation) {
  std::string text = "<section id=\"verdict\"><h2>Which method?</h2>\n";
  const std::vector<SceneGroup> groups = scene_groups(evaluation);
  text += groups.empty() ? "<p>No scene of this run has a contact whose law is known.</p>\n"
                         : fmt::format("<p>{}</p>\n", html_escaped(std::string(kVerdictRule)));
  for (const std::string& remark : {evaluation.times_remark(), unsteady_remark(evaluation)})
    if (!remark.empty()) text += fmt::format("<p>{}</p>\n", html_escaped(remark));
  text += "<div class=\"verdicts\">\n";
  for (const SceneGroup& group : groups) {
    std::string titles;
    for (const char* title : kErrorTitles)
      titles += fmt::format("<th scope=\"col\" class=\"n\">{}</th>", title);
    titles += "<th scope=\"col\" class=\"n\">unst.</th>";
    text += fmt::format(
        "<div class=\"table\"><table><caption>{}</caption><thead><tr><th "
        "scope=\"col\">method</th>{}</tr></thead><tbody>\n",
        html_escaped(verdict_title(group)), titles);
    for (const Standing& standing : group.standings) text += standing_row(standing);
    text += "</tbody></table></div>\n";
  }
  return text + "</div></section>\n";
}

std::string side_by_side(const Evaluation& evaluation) {
  std::string text =
      "<section id=\"side-by-side\"><h2>Scenes side by side</h2>\n<p>Error of x against time, on the same "
      "axes. Each mark is one resolution of a method and leads to its record. Hollow marks: error too small "
      "to measure (below ten error bars of the orbit), not ranked. Names below switch methods off and on, in "
      "every figure of the page.</p>\n" +
      std::string(kMethodSwitches) + "<div class=\"scenes\">\n";
  for (const std::string& scene : evaluation.scenes()) {
    text += fmt::format("<div><h3><a href=\"#scene-{0}\">{0}</a></h3>", html_escaped(scene)) +
            chart("small", scene, "Error against time, " + scene, "") + "</div>\n";
  }
  return text + "</div></section>\n";
}

std::string section_of(const Section& section, const char* heading) {
  std::string text =
      fmt::format("<section id=\"{0}\"><{2}>{1}</{2}>\n", section.id, html_escaped(section.title), heading);
  if (!section.text.empty()) text += fmt::format("<p>{}</p>\n", html_text(section.text));
  if (group_of(section)) {
    text +=
        kMethodSwitches + chart("profile", std::to_string(*group_of(section)), section.title,
                                "Share of all scenes that a method solves to the error above the panel "
                                "within a factor of the time of the fastest. A failure is infinitely slow.");
  }
  text += html_table(section.table, section.title);
  if (!section.note.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", html_text(section.note));
  return text + "</section>\n";
}

std::string scene_of(const std::string& scene, const Evaluation& evaluation,
                     std::span<const Section> sections, const Json& data) {
  Table laws = rows_of_scene(sections, "scenes", scene);
  const Table others = rows_of_scene(sections, "other-laws", scene);
  if (laws.header.empty()) laws.header = others.header;
  laws.rows.insert(laws.rows.end(), others.rows.begin(), others.rows.end());
  return fmt::format(
             "<section class=\"scene\" id=\"scene-{0}\"><h3>{0}</h3>\n<p>The scene's law: {1}. {2} <a "
             "href=\"#cases\" data-filter=\"{0}\">All runs on this scene</a>.</p>\n",
             html_escaped(scene), html_escaped(law_of_scene(evaluation, scene)),
             html_escaped(orbit_facts(evaluation, scene))) +
         (data["schematic"].is_null() ? ""
                                      : chart("schematic", scene, "The mechanical system of " + scene, "")) +
         charts_of(scene, data) +
         (laws.rows.empty() ? ""
                            : "<p>The law that each method represents, how many of its resolutions are "
                              "solved, and the time to each error of x and force:</p>\n" +
                                  html_table(laws, "Methods on " + scene)) +
         "</section>\n";
}

}  // namespace signorini
