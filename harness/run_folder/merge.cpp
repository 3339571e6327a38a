#include "harness/run_folder/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <unordered_set>

#include "harness/failure.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/run_folder/shards.hpp"
#include "harness/table.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kMachine{"/machine/cpu", "/machine/processors", "/machine/governor"};
constexpr std::array kRest{"/limits", "/build", "/suite", "/jobs"};

/// An entry of the manifest; null where there is none.
Json at(const RunFolder& run, const std::string& place) {
  const Json::json_pointer pointer(place);
  return run.manifest.contains(pointer) ? run.manifest.at(pointer) : Json();
}

/// The first entry that differs, for a message of one line.
std::optional<std::string> difference(const RunFolder& a, const RunFolder& b, const std::string& place) {
  const Json patch = Json::diff(at(a, place), at(b, place));
  if (patch.empty()) return std::nullopt;
  const std::string entry = place + patch.front().at("path").get<std::string>();
  std::string field = entry.substr(1);
  std::ranges::replace(field, '/', '.');
  return fmt::format("{}: {} = {} (must be {} as in {})", b.path.string(), field, json_text(at(b, entry)),
                     json_text(at(a, entry)), a.path.string());
}

template <class Places>
std::optional<std::string> first_difference(const RunFolder& a, const RunFolder& b, const Places& places) {
  for (const char* place : places) {
    if (auto found = difference(a, b, place)) return found;
  }
  return std::nullopt;
}

Json merged_manifest(std::span<const RunFolder> parts) {
  Json manifest = parts.front().manifest;
  Json shards = Json::array();
  for (const RunFolder& part : parts) {
    Json shard = Json::object();
    for (const char* key : {"date", "command_line", "shard"}) {
      if (part.manifest.contains(key)) shard[key] = part.manifest[key];
    }
    shard["load"] = at(part, "/machine/load");
    for (const char* key : {"load_end", "running"}) {
      const std::string place = std::string("/machine/") + key;
      if (const Json value = at(part, place); !value.is_null()) shard[key] = value;
    }
    shards.push_back(std::move(shard));
  }
  for (const char* key : {"date", "command_line", "shard"}) manifest.erase(key);
  if (manifest.contains("machine"))
    for (const char* key : {"load", "load_end", "running"}) manifest["machine"].erase(key);
  for (const RunFolder& part : parts) join_plugins(manifest, part.manifest);
  manifest["shards"] = std::move(shards);
  std::string why;  // of any part
  for (const RunFolder& part : parts)
    if (why.empty()) why = why_not_comparable(part.manifest);
  note_times(manifest, why);
  return manifest;
}

/// Natural order of the names of cases.
template <class Entry>
bool by_name(const Entry& a, const Entry& b) {
  return natural_less(a.case_id, b.case_id);
}

/// The records of all parts, each case once. \throws UsageError where one case has two different records
std::vector<RecordEntry> joined_records(std::vector<RunFolder>& parts) {
  std::vector<RecordEntry> records;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (RecordEntry& record : parts[part].records) {
      records.push_back(std::move(record));
      records.back().part = part;
    }
    parts[part].records = {};
  }
  std::ranges::stable_sort(records, by_name<RecordEntry>);
  for (std::size_t i = 1; i < records.size(); ++i) {
    if (records[i].case_id == records[i - 1].case_id && records[i].key != records[i - 1].key) {
      throw UsageError("{}: case = {} (must be of one scene file and one version of the code)",
                       parts[records[i].part].path.string(), records[i].case_id);
    }
  }
  const auto is_same = [](const RecordEntry& one, const RecordEntry& other) {
    return one.case_id == other.case_id;
  };
  records.erase(std::unique(records.begin(), records.end(), is_same), records.end());
  return records;
}

/// The cases of all plans, each key once.
std::vector<PlannedCase> joined_plans(std::vector<RunFolder>& parts) {
  std::vector<PlannedCase> plan;
  std::unordered_set<std::string_view> keys;
  std::size_t count = 0;
  for (const RunFolder& part : parts) count += part.plan.size();
  plan.reserve(count);  // so that the texts that `keys` knows stay where they are
  for (RunFolder& part : parts) {
    for (PlannedCase& one : part.plan) {
      if (keys.contains(one.key)) continue;
      plan.push_back(std::move(one));
      keys.insert(plan.back().key);
    }
    part.plan = {};
  }
  keys.clear();
  std::ranges::stable_sort(plan, by_name<PlannedCase>);
  return plan;
}

/// The shard of a run by its manifest; of a merge, the shards of its parts.
std::vector<Shard> shards_of(const RunFolder& part) {
  std::vector<Shard> shards;
  const auto add = [&](const Json& manifest) {
    if (manifest.contains("shard") && manifest["shard"].is_string())
      shards.push_back(parse_shard(manifest["shard"].get<std::string>()));
  };
  add(part.manifest);
  for (const Json& merged : at(part, "/shards")) add(merged);
  return shards;
}

/// \throws UsageError unless the shards among the parts make up a whole
void require_all_shards(std::span<const RunFolder> parts) {
  std::set<int> present;
  int count = 0;
  for (const RunFolder& part : parts) {
    for (const Shard& shard : shards_of(part)) {
      if (count == 0) count = shard.count;
      if (shard.count != count) {
        throw UsageError("{}: shard = {}/{} (must be one of {}, as in {})", part.path.string(), shard.index,
                         shard.count, count, parts.front().path.string());
      }
      present.insert(shard.index);
    }
  }
  std::string missing;
  for (int i = 1; i <= count; ++i) {
    if (!present.contains(i)) missing += fmt::format("{}{}/{}", missing.empty() ? "" : ", ", i, count);
  }
  if (!missing.empty()) throw UsageError("dirs = without shard {} (must be all shards of a run)", missing);
}

}  // namespace

std::optional<std::string> machine_difference(const RunFolder& a, const RunFolder& b) {
  return first_difference(a, b, kMachine);
}

std::optional<std::string> plugin_difference(const RunFolder& a, const RunFolder& b) {
  const Json theirs = at(b, "/plugins");
  for (const auto& [method, hash] : theirs.items()) {
    const std::string place = "/plugins/" + method;
    if (!at(a, place).is_null()) {
      if (auto found = difference(a, b, place)) return found;
    }
  }
  return std::nullopt;
}

void join_plugins(Json& manifest, const Json& other) {
  if (!other.contains("plugins")) return;
  for (const auto& [method, hash] : other["plugins"].items()) {
    Json& kept = manifest["plugins"][method];
    if (kept.is_null()) kept = hash;
  }
}

std::optional<std::string> mixture(const RunFolder& a, const RunFolder& b) {
  if (auto found = machine_difference(a, b)) return found;
  if (auto found = first_difference(a, b, kRest)) return found;
  return plugin_difference(a, b);
}

RunFolder merge_runs(std::vector<RunFolder> parts) {
  for (const RunFolder& part : parts) {
    if (const auto found = mixture(parts.front(), part)) throw UsageError(*found);
  }
  require_all_shards(parts);
  RunFolder merged;
  merged.manifest = merged_manifest(parts);
  merged.records = joined_records(parts);
  merged.plan = joined_plans(parts);
  return merged;
}

void require_no_run(const std::filesystem::path& out) {
  const std::filesystem::path manifest = out / "manifest.json";
  if (!std::filesystem::exists(manifest)) return;
  const Json known = read_manifest(manifest);
  if (known.contains("shards") || known.contains("runs")) return;
  throw UsageError("out = {} (must be a new folder or an earlier merge, not a run)", out.string());
}

void require_same_machine(const RunFolder& before, const RunFolder& now) {
  if (const auto found = machine_difference(before, now)) throw UsageError(*found);
}

std::vector<PlannedCase> joined_plan(const RunFolder& before, const RunFolder& now) {
  std::vector<PlannedCase> plan = now.plan;
  const auto same = [&](const char* place) {
    const Json then = at(before, place);
    return !then.is_null() && then == at(now, place);
  };
  if (!same("/limits") || !same("/build/sources") || plugin_difference(before, now)) return plan;
  std::unordered_set<std::string_view> cases;
  for (const PlannedCase& one : now.plan) cases.insert(one.case_id);
  std::ranges::copy_if(before.plan, std::back_inserter(plan),
                       [&](const PlannedCase& one) { return !cases.contains(one.case_id); });
  return plan;
}

}  // namespace signorini
