#include "harness/run_folder/manifest_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run_folder/shards.hpp"
#include "harness/text/json.hpp"
#include "problems/files/kebab_case.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestManifest = std::size_t{1} << 24U;  // bytes
constexpr double kLargestNumber = 1e9;                           // counts and MiB of a run

bool is_text(const Json& value) { return value.is_string(); }

bool is_number(const Json& value) { return value.is_number(); }

bool is_object(const Json& value) { return value.is_object(); }

template <bool (*Is)(const Json&)>
bool is_list_of(const Json& value) {
  return value.is_array() && std::all_of(value.begin(), value.end(), Is);
}

// Null where a shard's manifest says nothing of it.
bool is_load(const Json& value) { return value.is_null() || is_list_of<is_number>(value); }

bool is_table_of_texts(const Json& value) {
  return value.is_object() && std::all_of(value.begin(), value.end(), is_text);
}

bool is_one(const Json& value) { return value.is_number_integer() && value == 1; }

bool is_seed(const Json& value) { return value.is_number_integer(); }

// Counts are read as int.
bool is_count(const Json& value) {
  return value.is_number_integer() && value >= 1 && value <= kLargestNumber;
}

bool is_duration(const Json& value) { return value.is_number() && value >= 0; }

// A calibration solve takes milliseconds, and times are multiplied by ratios of such times.
bool is_scale(const Json& value) {
  constexpr double kLeast = 1e-6, kMost = 1e6;
  return value.is_number() && value >= kLeast && value <= kMost;
}

bool is_switch(const Json& value) { return value.is_boolean(); }

bool is_suite(const Json& value) {
  return value.is_string() && is_lower_kebab_case(value.get_ref<const std::string&>());
}

bool is_shard(const Json& value) {
  if (!value.is_string()) return false;
  try {
    parse_shard(value.get_ref<const std::string&>());
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

bool is_table_of_methods(const Json& value) {
  if (!is_table_of_texts(value)) return false;
  for (const auto& item : value.items()) {
    if (!is_lower_kebab_case(item.key())) return false;
  }
  return true;
}

struct Rule {
  const char* place;  // a JSON pointer
  bool (*holds)(const Json&);
  const char* requirement;
};

constexpr const char* kText = "must be a text";
constexpr const char* kCount = "must be a whole number, 1..1e9";
constexpr const char* kDuration = "must be a number >= 0";
constexpr const char* kObject = "must be an object";
constexpr const char* kScale = "must be a number in 1e-6..1e6";

// Of a run, and of each shard of a merge.
constexpr std::array kOfShard{
    Rule{"/date", is_text, kText},
    Rule{"/command_line", is_list_of<is_text>, "must be a list of words"},
    Rule{"/shard", is_shard, "must be I/N with 1 <= I <= N"},
    Rule{"/load", is_load, "must be a list of numbers"},
    Rule{"/load_end", is_load, "must be a list of numbers"},
    Rule{"/running", is_duration, kDuration},
};

// Of each of the runs that stand side by side.
constexpr std::array kOfNamedRun{
    Rule{"/name", is_text, kText},
    Rule{"/times_left_out", is_text, kText},
    Rule{"/times_multiplied_by", is_scale, kScale},
};

constexpr std::array kOfRun{
    Rule{"/schema", is_one, "must be 1"},
    Rule{"/suite", is_suite, "must be the name of a suite"},
    Rule{"/order", is_text, kText},
    Rule{"/seed", is_seed, "must be a whole number"},
    Rule{"/jobs", is_count, kCount},
    Rule{"/times_comparable", is_switch, "must be true or false"},
    Rule{"/times_not_comparable", is_text, kText},
    Rule{"/limits", is_object, kObject},
    Rule{"/limits/timeout_s", is_duration, kDuration},
    Rule{"/limits/memory_mb", is_count, kCount},
    Rule{"/limits/repetitions", is_count, kCount},
    Rule{"/limits/certificate_timeout_s", is_duration, kDuration},
    Rule{"/limits/reference_timeout_s", is_duration, kDuration},
    Rule{"/build", is_object, kObject},
    Rule{"/build/version", is_text, kText},
    Rule{"/build/commit", is_text, kText},
    Rule{"/build/dirty", is_switch, "must be true or false"},
    Rule{"/build/compiler", is_text, kText},
    Rule{"/build/flags", is_text, kText},
    Rule{"/build/build_type", is_text, kText},
    Rule{"/build/timings_count", is_switch, "must be true or false"},
    Rule{"/build/libraries", is_table_of_texts, "must be an object of texts"},
    Rule{"/build/sources", is_table_of_texts, "must be an object of texts"},
    Rule{"/machine", is_object, kObject},
    Rule{"/machine/cpu", is_text, kText},
    Rule{"/machine/processors", is_count, kCount},
    Rule{"/machine/governor", is_text, kText},
    Rule{"/machine/kernel", is_text, kText},
    Rule{"/machine/load", is_list_of<is_number>, "must be a list of numbers"},
    Rule{"/machine/load_end", is_list_of<is_number>, "must be a list of numbers"},
    Rule{"/machine/running", is_duration, kDuration},
    Rule{"/calibration", is_object, kObject},
    Rule{"/calibration/version", is_count, kCount},
    Rule{"/calibration/seconds", is_scale, kScale},
    Rule{"/calibration/solves", is_count, kCount},
    Rule{"/plugins", is_table_of_methods, "must be an object of texts, by names of methods"},
    Rule{"/sweep", is_object, kObject},
    Rule{"/shards", is_list_of<is_object>, "must be a list of objects"},
    Rule{"/runs", is_list_of<is_object>, "must be a list of objects"},
};

// "limits.timeout_s" of "/limits/timeout_s".
std::string field_of(std::string place) {
  std::ranges::replace(place, '/', '.');
  return place.substr(1);
}

void require(const Json& object, const Rule& rule, const std::string& group) {
  const Json::json_pointer place(rule.place);
  if (!object.contains(place) || rule.holds(object.at(place))) return;
  throw BadRecord("{}{} = {} ({})", group, field_of(rule.place), one_line(json_text(object.at(place))),
                  rule.requirement);
}

void require_plausible(const Json& manifest) {
  for (const Rule& rule : kOfRun) require(manifest, rule, "");
  for (const Rule& rule : kOfShard) require(manifest, rule, "");
  const auto require_each = [&](const char* list, const auto& rules) {
    if (!manifest.contains(list)) return;
    for (std::size_t i = 0; i < manifest[list].size(); ++i) {
      for (const Rule& rule : rules) require(manifest[list][i], rule, fmt::format("{}[{}].", list, i));
    }
  };
  require_each("shards", kOfShard);
  require_each("runs", kOfNamedRun);
}

}  // namespace

Json parse_manifest(const std::string& text, const std::string& name) {
  Json manifest = try_parse_json(text);
  try {
    if (!manifest.is_object()) throw BadRecord("manifest = unreadable (must be one JSON object)");
    require_plain_texts(manifest);
    require_plausible(manifest);
    return manifest;
  } catch (const BadRecord& error) {
    throw UsageError("{}: {}", name, error.what());
  }
}

Json read_manifest(const std::filesystem::path& file) {
  return parse_manifest(read_file(file, kLargestManifest), file.string());
}

}  // namespace signorini
