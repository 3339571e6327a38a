#include "harness/conformance/check_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "harness/records/json_fields.hpp"

namespace signorini {

namespace {

std::size_t count_of(std::span<const CheckResult> results, CheckOutcome outcome) {
  return static_cast<std::size_t>(
      std::ranges::count_if(results, [&](const CheckResult& result) { return result.outcome == outcome; }));
}

std::string scenes_text(std::size_t count) { return fmt::format("{} scene{}", count, count == 1 ? "" : "s"); }

/// "passed on 7 scenes, nothing to look at on 2".
std::string summary(std::span<const CheckResult> results) {
  if (results.front().scene.empty()) return std::string(enum_name(results.front().outcome));
  const std::size_t failed = count_of(results, CheckOutcome::failed);
  const std::size_t nothing = count_of(results, CheckOutcome::not_applicable);
  const std::size_t passed = results.size() - failed - nothing;
  std::string text;
  const auto add = [&](std::string part) { text += (text.empty() ? "" : ", ") + part; };
  if (failed > 0) add("FAILED on " + scenes_text(failed));
  if (passed > 0) add("passed on " + scenes_text(passed));
  if (nothing > 0) add("nothing to look at on " + scenes_text(nothing));
  return text;
}

std::string reproduction(const MethodEntry& entry, const CheckResult& result) {
  if (!result.reproduce.empty()) return result.reproduce;
  const std::string scene = result.scene.empty() ? "" : " --scenes " + result.scene;
  return fmt::format("signorini check {} --checks {}{}", entry.name, result.check, scene);
}

std::string remark(const MethodEntry& entry, const CheckResult& result, const std::string& further_words) {
  const std::string where = result.scene.empty() ? "" : result.scene + ": ";
  std::string text = fmt::format("    {}{}\n", where, result.why);
  if (result.outcome == CheckOutcome::failed)
    text += fmt::format("      {}{}\n", reproduction(entry, result), further_words);
  return text;
}

std::string paragraph(const MethodEntry& entry, std::span<const CheckResult> results,
                      const std::string& further_words) {
  std::string text =
      fmt::format("  {:<18} {}: {}\n", results.front().check, results.front().promise, summary(results));
  for (const CheckOutcome outcome : {CheckOutcome::failed, CheckOutcome::remarked}) {
    for (const CheckResult& result : results) {
      if (result.outcome == outcome) text += remark(entry, result, further_words);
    }
  }
  return text;
}

}  // namespace

void visit_fields(Either<CheckResult> auto& result, auto&& field) {
  field(Field{"check"}, result.check);
  field(Field{"promise"}, result.promise);
  field(Field{"scene"}, result.scene);
  field(required("outcome"), result.outcome);
  field(Field{"why"}, result.why);
  field(Field{"reproduce"}, result.reproduce);
}

CheckResult passed() { return {}; }
CheckResult remarked(std::string why) { return {.outcome = CheckOutcome::remarked, .why = std::move(why)}; }
CheckResult failed(std::string why) { return {.outcome = CheckOutcome::failed, .why = std::move(why)}; }
CheckResult passed_unless(std::string defect) {
  return defect.empty() ? passed() : failed(std::move(defect));
}

CheckResult not_applicable(std::string why) {
  return {.outcome = CheckOutcome::not_applicable, .why = std::move(why)};
}

nlohmann::ordered_json to_json(const CheckResult& result) { return write_fields(result); }

CheckResult check_result_from_json(const nlohmann::ordered_json& json) {
  CheckResult result;
  read_fields(json, result);
  return result;
}

std::string review_text(const MethodEntry& entry, const std::vector<CheckResult>& results,
                        const std::string& further_words) {
  std::string text = fmt::format("{}: {}\n", entry.name, entry.title);
  const std::span all(results);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].check == all[begin].check) ++end;
    text += paragraph(entry, all.subspan(begin, end - begin), further_words);
    begin = end;
  }
  return text + fmt::format("{}: {} passed, {} failed, {} remarks, {} had nothing to look at\n", entry.name,
                            count_of(all, CheckOutcome::passed), count_of(all, CheckOutcome::failed),
                            count_of(all, CheckOutcome::remarked),
                            count_of(all, CheckOutcome::not_applicable));
}

}  // namespace signorini
