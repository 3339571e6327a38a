#include "harness/records/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "harness/failure.hpp"
#include "harness/records/shards.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

constexpr std::array kMachine{"/machine/cpu", "/machine/processors", "/machine/governor"};
constexpr std::array kRest{"/limits", "/build", "/suite", "/jobs"};

Json at(const RunFolder& run, const char* place) {
  const Pointer pointer(place);
  return run.manifest.contains(pointer) ? run.manifest.at(pointer) : Json();
}

/// The innermost entry that differs, for a message of one line.
std::optional<std::string> difference(const RunFolder& a, const RunFolder& b, const std::string& place) {
  const Json left = at(a, place.c_str()), right = at(b, place.c_str());
  if (left == right) return std::nullopt;
  if (left.is_object() && right.is_object()) {
    for (const auto& [key, value] : left.items()) {
      if (auto inner = difference(a, b, place + "/" + key)) return inner;
    }
  }
  std::string field = place.substr(1);
  std::replace(field.begin(), field.end(), '/', '.');
  return fmt::format("{}: {} = {} (must be {} as in {})", b.path.string(), field, right.dump(), left.dump(),
                     a.path.string());
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
    shards.push_back(std::move(shard));
  }
  for (const char* key : {"date", "command_line", "shard"}) manifest.erase(key);
  if (manifest.contains("machine")) manifest["machine"].erase("load");
  for (const RunFolder& part : parts) join_plugins(manifest, part.manifest);
  manifest["shards"] = std::move(shards);
  return manifest;
}

/// Adds records that are not there yet. \throws UsageError where one case has two different records
void add_records(const RunFolder& part, std::map<std::string, std::string>& keys,
                 std::vector<Record>& records) {
  for (const Record& record : part.records) {
    const auto [known, fresh] = keys.try_emplace(record.case_id, record.key);
    if (fresh) records.push_back(record);
    if (known->second != record.key) {
      throw UsageError(fmt::format("{}: case = {} (must be of one scene file and one version of the code)",
                                   part.path.string(), record.case_id));
    }
  }
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
        throw UsageError(fmt::format("{}: shard = {}/{} (must be one of {}, as in {})", part.path.string(),
                                     shard.index, shard.count, count, parts.front().path.string()));
      }
      present.insert(shard.index);
    }
  }
  std::string missing;
  for (int i = 1; i <= count; ++i) {
    if (!present.contains(i)) missing += fmt::format("{}{}/{}", missing.empty() ? "" : ", ", i, count);
  }
  if (!missing.empty())
    throw UsageError(fmt::format("dirs = without shard {} (must be all shards of a run)", missing));
}

}  // namespace

std::optional<std::string> machine_difference(const RunFolder& a, const RunFolder& b) {
  return first_difference(a, b, kMachine);
}

bool same_machine(const RunFolder& a, const RunFolder& b) { return !machine_difference(a, b); }

std::optional<std::string> plugin_difference(const RunFolder& a, const RunFolder& b) {
  const Json theirs = at(b, "/plugins");
  for (const auto& [method, hash] : theirs.items()) {
    const std::string place = "/plugins/" + method;
    if (!at(a, place.c_str()).is_null()) {
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

RunFolder merge_runs(std::span<const RunFolder> parts) {
  for (const RunFolder& part : parts) {
    if (const auto found = mixture(parts.front(), part)) throw UsageError(*found);
  }
  require_all_shards(parts);
  RunFolder merged;
  merged.manifest = merged_manifest(parts);
  std::map<std::string, std::string> keys;
  std::set<std::string> planned;
  for (const RunFolder& part : parts) {
    add_records(part, keys, merged.records);
    for (const PlannedCase& one : part.plan) {
      if (planned.insert(one.key).second) merged.plan.push_back(one);
    }
  }
  const auto before = [](const auto& a, const auto& b) { return natural_less(a.case_id, b.case_id); };
  std::stable_sort(merged.records.begin(), merged.records.end(), before);
  std::stable_sort(merged.plan.begin(), merged.plan.end(), before);
  return merged;
}

}  // namespace signorini
