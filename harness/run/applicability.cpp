#include "harness/run/applicability.hpp"

#include <nlohmann/json.hpp>

#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kSecondsPerMethod = 10.0;

void send_answer(const Scene& scene, const Case& planned_case, const LineSender& send) {
  const std::unique_ptr<Method> method = planned_case.choice.make();
  const Support support = method->supports(scene.problem);
  Json json{{"applies", support.ok}, {"reason", support.reason}};
  if (support.ok) json["law"] = law_to_json(method->law(scene.problem));
  send(json_line(json));
}

Applicability read_answer(const std::string& line) {
  const Json json = Json::parse(line);
  Applicability answer{.applies = json.at("applies"), .reason = json.at("reason")};
  if (json.contains("law")) answer.law = law_from_json(json["law"]);
  return answer;
}

}  // namespace

std::vector<Applicability> ask_applicability(const Scene& scene, std::span<const Case* const> cases,
                                             int memory_mb) {
  std::vector<Applicability> answers;
  while (answers.size() < cases.size() && !interrupted()) {
    const auto rest = cases.subspan(answers.size());
    const ChildEnd end = run_isolated(
        [&](const LineSender& send) {
          for (const Case* planned_case : rest) send_answer(scene, *planned_case, send);
        },
        {.stage_seconds = {kSecondsPerMethod}, .memory_mb = memory_mb});
    for (const std::string& line : end.lines) answers.push_back(read_answer(line));
    // The method that ended the child gets its ending; those after it are asked in another child.
    if (end.kind != ChildEnd::Kind::finished && answers.size() < cases.size())
      answers.push_back({.failure = end});
  }
  return answers;
}

}  // namespace signorini
