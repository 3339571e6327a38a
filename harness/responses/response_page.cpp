#include "harness/responses/response_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/report/document/lines.hpp"
#include "harness/report/page/html.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/page/page_shell.hpp"
#include "harness/responses/response_sections.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// With as many digits as a figure shows when it is enlarged.
Json to_digits(const std::vector<double>& values, int digits) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::stod(fmt::format("{:.{}g}", value, digits)));
  return list;
}

Json branch_data(const std::vector<DrawnBranch>& branches) {
  constexpr int kFrequencyDigits = 8, kAmplitudeDigits = 6;
  Json list = Json::array();
  for (const DrawnBranch& branch : branches)
    list.push_back({{"w", to_digits(branch.frequency, kFrequencyDigits)},
                    {"a", to_digits(branch.amplitude, kAmplitudeDigits)},
                    {"s", branch.stable}});
  return list;
}

Json point_data(const ResponseRecord& record) {
  Json list = Json::array();
  for (const LocatedPoint& point : record.located) {
    if (!point.amplitude) continue;
    const bool invented =
        record.comparison && std::ranges::any_of(record.comparison->invented, [&](const LocatedPoint& other) {
          return other.kind == point.kind && other.order == point.order && other.frequency == point.frequency;
        });
    list.push_back({describe(point.kind), point.frequency, *point.amplitude, point.order, invented ? 0 : 1});
  }
  return list;
}

/// Scenes in the order of their first records.
std::vector<std::string> scenes_followed(std::span<const ResponseRecord> records) {
  std::vector<std::string> scenes;
  for (const ResponseRecord& record : records)
    if (std::ranges::find(scenes, record.scene) == scenes.end()) scenes.push_back(record.scene);
  return scenes;
}

const ResponseRecord* exact_record_of(std::span<const ResponseRecord> records, const std::string& scene) {
  const auto found = std::ranges::find_if(
      records, [&](const ResponseRecord& record) { return is_exact(record) && record.scene == scene; });
  return found == records.end() ? nullptr : &*found;
}

/// The rows of a section that belong to a scene, of these columns.
Table rows_of_response(const Section& section, const std::string& scene,
                       const std::vector<std::string>& columns) {
  Table table{.header = columns, .rows = {}};
  for (const std::vector<Cell>& row : section.table.rows) {
    if (row.front().text != scene) continue;
    std::vector<Cell>& kept = table.rows.emplace_back();
    for (const std::string& column : columns)
      kept.push_back(row[static_cast<std::size_t>(std::ranges::find(section.table.header, column) -
                                                  section.table.header.begin())]);
  }
  return table;
}

const Section& section_called(const std::vector<Section>& sections, const std::string& id) {
  return *std::ranges::find(sections, id, &Section::id);
}

std::string facts_of_exact(const ResponseRecord& exact, std::size_t place) {
  std::string text = fmt::format(
      "<p>The <a href=\"#{}\">exact response</a> from {:.6g} to {:.6g} rad/s: {}, up to periods of {}",
      record_anchor(place), std::min(exact.from, exact.to), std::max(exact.from, exact.to),
      std::ssize(exact.branches) == 1 ? "1 branch" : fmt::format("{} branches", exact.branches.size()),
      plural(exact.orders, "forcing period"));
  std::vector<std::string> open = exact.open_ends;
  if (!exact.message.empty()) open.push_back(exact.message);
  if (!open.empty()) text += html_escaped(fmt::format("; left open: {}", joined(open, "; ")));
  return text + ".</p>\n";
}

std::string response_of(const std::string& scene, std::span<const ResponseRecord> records,
                        const std::vector<Section>& sections, const Json& data) {
  std::string text =
      fmt::format("<section class=\"scene\" id=\"scene-{0}\"><h3>{0}</h3>\n", html_escaped(scene));
  if (const ResponseRecord* exact = exact_record_of(records, scene))
    text += facts_of_exact(*exact, static_cast<std::size_t>(exact - records.data()));
  if (!data.is_null())
    text +=
        std::string(kMethodSwitches) + "<div class=\"beside\">\n" +
        chart(
            "response", scene, "Amplitude over the frequency of the load, " + scene,
            "Half the range of x of the contact that moves most. Broad and grey: the exact response; lines: "
            "methods by arc length; dots: by steps of the frequency. Solid where stable, dashed where "
            "unstable, thin where that is not known. Hollow marks are points that are not on the exact "
            "response.");
  else
    text += "<div>\n";
  text += html_table(
              rows_of_response(section_called(sections, "response-cases"), scene,
                               {"method", "other law", "found", "false", "located", "largest error", "time"}),
              "Methods on " + scene) +
          "</div>\n";
  Table located = rows_of_response(section_called(sections, "located"), scene,
                                   section_called(sections, "located").table.header);
  if (!located.rows.empty()) {
    located.header.erase(located.header.begin());
    for (std::vector<Cell>& row : located.rows) row.erase(row.begin());
    text +=
        "<p>Special points of the exact response, and the relative error of the frequency at which each "
        "method located them:</p>\n" +
        html_table(located, "Special points of " + scene);
  }
  return text + "</section>\n";
}

/// Everything that the script needs.
Json page_data(std::span<const ResponseRecord> records, const std::vector<std::string>& scenes) {
  Json data{{"configurations", labels_of(records)}, {"steps", Json::array()}, {"cases", Json::array()}};
  for (const std::string& label : labels_of(records)) data["steps"].push_back(label.ends_with(" by steps"));
  for (const ResponseRecord& record : records) {
    Json json = parse_json(response_line(record));
    json.erase("branches");  // left to the figures
    data["cases"].push_back(is_exact(record) ? record.scene + ", exact response" : record.case_id);
    data["records"].push_back(printed(json));
  }
  for (const std::string& scene : scenes)
    data["scenes"][scene] = {{"response", response_data(records, scene)}};
  return data;
}

std::string contents(const std::vector<std::string>& scenes) {
  std::string items;
  for (const std::string& scene : scenes) items += item("scene-" + scene, scene);
  return contents_of(list_part("", item("verdict", "Which method?")) + list_part("Scenes", items) +
                     list_part("All together", item("responses", "Each method") +
                                                   item("cases", "Each response") +
                                                   item("open-ends", "Where the exact responses are open")) +
                     list_part("", item("about", "How this run was made")));
}

/// What each kind of scenes recommends.
std::string verdict_section_of(const Section& verdict) {
  const std::string table = verdict.table.rows.empty() ? "" : html_table(verdict.table, "Which method?");
  return fmt::format(
      "<section id=\"verdict\"><h2>Which method?</h2>\n{}<p class=\"note\">{}</p>\n"
      "<p class=\"note\">{}</p>\n</section>\n",
      table, html_text(verdict.text), html_text(verdict.note));
}

}  // namespace

Json response_data(std::span<const ResponseRecord> records, const std::string& scene) {
  const ResponseRecord* exact = exact_record_of(records, scene);
  if (exact == nullptr || exact->branches.empty()) return {};
  const std::vector<std::string> labels = labels_of(records);
  Json methods = Json::array();
  for (std::size_t place = 0; place < records.size(); ++place) {
    const ResponseRecord& record = records[place];
    if (record.scene != scene || is_exact(record) || record.branches.empty()) continue;
    const std::string label = label_of(record);
    methods.push_back({{"c", std::ranges::find(labels, label) - labels.begin()},
                       {"record", place},
                       {"label", label},
                       {"steps", record.by_steps},
                       {"branches", branch_data(record.branches)},
                       {"points", point_data(record)}});
  }
  return {{"from", std::min(exact->from, exact->to)},
          {"to", std::max(exact->from, exact->to)},
          {"exact",
           {{"record", exact - records.data()},
            {"branches", branch_data(exact->branches)},
            {"points", point_data(*exact)}}},
          {"methods", std::move(methods)}};
}

std::string response_page(const std::string& title, const Json& manifest,
                          std::span<const ResponseRecord> records) {
  const std::vector<std::string> scenes = scenes_followed(records);
  const std::vector<Section> sections = response_sections(records);
  const Json data = page_data(records, scenes);
  std::string text = verdict_section_of(section_called(sections, "verdict"));
  text += "<h2>Scene by scene</h2>\n";
  for (const std::string& scene : scenes)
    text += response_of(scene, records, sections, data["scenes"][scene]["response"]);
  Section cases = section_called(sections, "response-cases");
  cases.id = "cases";  // where names of methods lead
  text += section_of(section_called(sections, "responses")) + section_of(cases) +
          section_of(section_called(sections, "open-ends"));
  const auto methods = std::ssize(labels_of(records));
  return whole_page({.title = title,
                     .summary = fmt::format("Frequency responses: {} of {}", plural(methods, "method"),
                                            plural(std::ssize(scenes), "scene")),
                     .contents = contents(scenes),
                     .main = text + about_section(manifest)},
                    data);
}

}  // namespace signorini
