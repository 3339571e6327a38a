#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/records/record_json.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/page/page_shell.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// With as many digits as a figure shows when it is enlarged.
Json branch_data(const std::vector<DrawnBranch>& branches) {
  Json list = Json::array();
  for (const DrawnBranch& branch : branches)
    list.push_back(
        {{"w", rounded(branch.frequency, 8)}, {"a", rounded(branch.amplitude, 6)}, {"s", branch.stable}});
  return list;
}

Json point_data(const RecordedResponse& response) {
  Json list = Json::array();
  for (const LocatedPoint& point : response.located) {
    if (!point.amplitude) continue;
    const auto is_it = [&](const LocatedPoint& other) {
      return other.kind == point.kind && other.order == point.order && other.frequency == point.frequency;
    };
    const bool invented = response.comparison && std::ranges::any_of(response.comparison->invented, is_it);
    list.push_back({enum_name(point.kind), point.frequency, *point.amplitude, point.order, invented ? 0 : 1});
  }
  return list;
}

/// The place of the exact response of a scene among the responses; empty where there is none.
std::optional<std::size_t> place_of_exact(const Evaluation& evaluation, const std::string& scene) {
  const std::vector<Record>& records = evaluation.responses();
  const auto found = std::ranges::find_if(
      records, [&](const Record& record) { return is_exact(record) && record.scene == scene; });
  if (found == records.end()) return std::nullopt;
  return static_cast<std::size_t>(found - records.begin());
}

std::string facts_of_exact(const Record& exact, std::size_t place) {
  const RecordedResponse& response = *exact.response;
  const ResponseQuestion& asked = response.question;
  std::string text = fmt::format(
      "<p>The <a href=\"#{}\">exact response</a> from {:.6g} to {:.6g} rad/s: {} branch{}, up to periods of "
      "{}",
      record_anchor(place), std::min(asked.from, asked.to), std::max(asked.from, asked.to),
      response.branches.size(), response.branches.size() == 1 ? "" : "es",
      plural(asked.orders, "forcing period"));
  std::vector<std::string> open = response.open_ends;
  if (!exact.message.empty()) open.push_back(exact.message);
  if (!open.empty()) text += html_escaped(fmt::format("; left open: {}", joined(open, "; ")));
  return text + ".</p>\n";
}

}  // namespace

bool shows_motions(const Evaluation& evaluation) {
  return !evaluation.results().empty() || evaluation.responses().empty();
}

std::vector<std::string> scenes_followed(const Evaluation& evaluation) {
  std::vector<std::string> scenes;
  for (const Record& record : evaluation.responses())
    if (std::ranges::find(scenes, record.scene) == scenes.end()) scenes.push_back(record.scene);
  return scenes;
}

std::string response_anchor(const Evaluation& evaluation, const std::string& scene) {
  return (std::ranges::count(evaluation.scenes(), scene) > 0 ? "response-" : "scene-") + scene;
}

Json response_data(const Evaluation& evaluation, const std::string& scene) {
  const std::vector<Record>& records = evaluation.responses();
  const std::optional<std::size_t> exact = place_of_exact(evaluation, scene);
  if (!exact || records[*exact].response->branches.empty()) return {};
  const std::vector<std::string> labels = response_labels(records);
  const auto configurations = std::ssize(evaluation.configurations());
  Json methods = Json::array();
  for (std::size_t i = 0; i < records.size(); ++i) {
    const RecordedResponse& response = *records[i].response;
    if (records[i].scene != scene || i == *exact || response.branches.empty()) continue;
    const auto label = std::ranges::find(labels, response_label(records[i]));
    methods.push_back({{"c", configurations + (label - labels.begin())},
                       {"record", evaluation.place_of_response(i)},
                       {"label", label_with_law(records[i])},
                       {"steps", response.question.way == ResponseWay::steps},
                       {"branches", branch_data(response.branches)},
                       {"points", point_data(response)}});
  }
  const RecordedResponse& truth = *records[*exact].response;
  return {{"from", std::min(truth.question.from, truth.question.to)},
          {"to", std::max(truth.question.from, truth.question.to)},
          {"exact",
           {{"record", evaluation.place_of_response(*exact)},
            {"branches", branch_data(truth.branches)},
            {"points", point_data(truth)}}},
          {"methods", std::move(methods)}};
}

std::string response_of(const std::string& scene, const Evaluation& evaluation,
                        std::span<const Section> sections, const Json& data) {
  std::string text = fmt::format("<section class=\"scene\" id=\"{}\"><h3>{}, response</h3>\n",
                                 html_escaped(response_anchor(evaluation, scene)), html_escaped(scene));
  if (const std::optional<std::size_t> exact = place_of_exact(evaluation, scene))
    text += facts_of_exact(evaluation.responses()[*exact], evaluation.place_of_response(*exact));
  if (!data.is_null())
    text += std::string(kMethodSwitches) + "<div class=\"beside\">\n" +
            chart("response", scene, "Amplitude over the frequency of the load, " + scene,
                  "Half the range of x of the contact that moves most. Broad and grey: the exact response; "
                  "lines: methods by arc length; dots: by steps of the frequency. Solid where stable, dashed "
                  "where unstable, thin where that is not known. Hollow marks are points that are not on the "
                  "exact response.");
  else
    text += "<div>\n";
  const Table cases =
      rows_of_scene(sections, "response-cases", scene,
                    {"method", "other law", "found", "false", "located", "largest error", "time"});
  text += html_table(cases, "Methods on " + scene) + "</div>\n";
  if (const Table located = rows_of_scene(sections, "located", scene); !located.rows.empty())
    text +=
        "<p>Special points of the exact response, and the relative error of the frequency at which each "
        "method located them:</p>\n" +
        html_table(located, "Special points of " + scene);
  return text + "</section>\n";
}

}  // namespace signorini
