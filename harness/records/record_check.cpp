#include "harness/records/record_check.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "harness/records/record_json.hpp"
#include "problems/files/kebab_case.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

constexpr std::size_t kLongestMessage = 1000;
constexpr int kDeepest = 32;  // levels of a record; those of a run have eight at most

void require_plain(const std::string& text) {
  if (text.size() <= kLongestText && !has_control_characters(text)) return;
  throw BadRecord("text = {} (must be at most {} bytes without control characters)", one_line(text),
                  kLongestText);
}

[[noreturn]] void refuse(std::string_view field, std::string_view value, std::string_view requirement) {
  throw BadRecord("{} = {} ({})", field, value, requirement);
}

/// Refuses numbers below zero in every field of a visited struct.
void require_no_less_than_zero(std::string_view group, const auto& object) {
  visit_fields(object, [&]<class T>(const Field& field, const T& value) {
    double number = 0.0;
    if constexpr (std::is_arithmetic_v<T>) number = static_cast<double>(value);
    if constexpr (requires { number = static_cast<double>(*value); }) {
      if (value) number = static_cast<double>(*value);
    }
    if (number < 0.0)
      refuse(fmt::format("{}.{}", group, field.name), fmt::format("{}", number), "must be 0 or more");
  });
}

/// All texts of a value that nests no deeper than `depth`: each level is a call here, and the parser allows
/// any number of them.
void require_plain_below(const nlohmann::ordered_json& json, int depth) {
  if (json.is_string()) require_plain(json.get_ref<const std::string&>());
  if (!json.is_structured()) return;
  if (depth == 0) throw BadRecord("value = nested (must be at most {} levels deep)", kDeepest);
  for (const auto& item : json.items()) {
    if (json.is_object()) require_plain(item.key());
    require_plain_below(item.value(), depth - 1);
  }
}

/// Lists of one length, which figures go through together.
void require_drawable(const RecordedResponse& response) {
  for (const DrawnBranch& branch : response.branches) {
    if (branch.amplitude.size() != branch.frequency.size() || branch.stable.size() != branch.frequency.size())
      refuse("branches", fmt::format("{} frequencies", branch.frequency.size()),
             "must have as many amplitudes and stabilities");
  }
}

/// Names, counts and numbers as a run gives them.
void require_plausible(const Record& record) {
  if (!is_scene_name(record.scene)) refuse("scene", record.scene, "must be the name of a scene");
  if (!is_lower_kebab_case(record.method)) refuse("method", record.method, "must be the name of a method");
  require_no_less_than_zero("work", record.work);
  require_no_less_than_zero("errors", record.errors);
  if (record.seconds) require_no_less_than_zero("seconds", *record.seconds);
  if (record.period && !(*record.period > 0.0))
    refuse("period", fmt::format("{}", *record.period), "must be positive");
  if (record.response) require_drawable(*record.response);
  if (record.instance && !is_lower_kebab_case(record.instance->scene))
    refuse("instance.name", record.instance->scene, "must be the name of a scene");
  if (record.instance && record.instance->number < 1)
    refuse("instance.number", fmt::format("{}", record.instance->number), "must be 1 or more");
  if (!record.family) return;
  const FamilyLevel& family = *record.family;
  if (!is_lower_kebab_case(family.family))
    refuse("family.name", family.family, "must be the name of a family");
  if (family.severity < 1 || family.severity > family.levels)
    refuse("family.severity", fmt::format("{}", family.severity), "must be in 1..levels");
}

}  // namespace

void require_plain_texts(const nlohmann::ordered_json& json) { require_plain_below(json, kDeepest); }

std::string as_message(const std::string& text) { return one_line(text, kLongestMessage); }

Record checked_record(const nlohmann::ordered_json& json) {
  require_plain_texts(json);
  Record record = record_from_json(json);
  require_plausible(record);
  return record;
}

}  // namespace signorini
