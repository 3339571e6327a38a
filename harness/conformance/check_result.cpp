#include "harness/conformance/check_result.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kOutcomes{"passed", "remarked", "not-applicable", "failed"};

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
  const auto add = [&json](const char* key, std::string_view text) {
    if (!text.empty()) json[key] = text;
  };
  add("check", result.check);
  add("promise", result.promise);
  add("scene", result.scene);
  add("outcome", outcome_name(result.outcome));
  add("why", result.why);
  add("reproduce", result.reproduce);
  return json;
}

CheckResult check_result_from_json(const Json& json) {
  CheckResult result;
  const std::string name = json.at("outcome");
  for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
    if (kOutcomes[i] == name) result.outcome = static_cast<CheckOutcome>(i);
  }
  result.why = json.value("why", "");
  result.reproduce = json.value("reproduce", "");
  result.check = json.value("check", "");
  result.promise = json.value("promise", "");
  result.scene = json.value("scene", "");
  return result;
}

}  // namespace signorini
