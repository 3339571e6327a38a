#include "harness/conformance/finding.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kOutcomes{"passed", "remarked", "not-applicable", "failed"};

void add_result(const CheckResult& result, Json& json) {
  json["outcome"] = outcome_name(result.outcome);
  if (!result.why.empty()) json["why"] = result.why;
  if (!result.reproduce.empty()) json["reproduce"] = result.reproduce;
}

}  // namespace

std::string_view outcome_name(CheckOutcome outcome) { return kOutcomes[static_cast<std::size_t>(outcome)]; }

CheckResult passed() { return {}; }
CheckResult remarked(std::string why) { return {.outcome = CheckOutcome::remarked, .why = std::move(why)}; }
CheckResult failed(std::string why) { return {.outcome = CheckOutcome::failed, .why = std::move(why)}; }
CheckResult not_applicable(std::string why) {
  return {.outcome = CheckOutcome::not_applicable, .why = std::move(why)};
}

Json to_json(const CheckResult& result) {
  Json json;
  add_result(result, json);
  return json;
}

CheckResult result_from_json(const Json& json) {
  CheckResult result;
  const std::string name = json.at("outcome");
  for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
    if (kOutcomes[i] == name) result.outcome = static_cast<CheckOutcome>(i);
  }
  result.why = json.value("why", "");
  result.reproduce = json.value("reproduce", "");
  return result;
}

Json to_json(const CheckFinding& finding) {
  Json json{{"check", finding.check}, {"promise", finding.promise}};
  if (!finding.scene.empty()) json["scene"] = finding.scene;
  add_result(finding.result, json);
  return json;
}

}  // namespace signorini
