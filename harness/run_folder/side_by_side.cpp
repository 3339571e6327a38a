#include "harness/run_folder/side_by_side.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "harness/run_folder/machine_load.hpp"
#include "harness/run_folder/merge.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct NamedRun {
  std::string name = {};
  RunFolder folder = {};         ///< description alone
  std::string hides_times = {};  ///< why; empty where its times may stand beside those of the first
};

std::vector<NamedRun> named_runs(std::span<const fs::path> folders) {
  std::vector<NamedRun> runs;
  for (const fs::path& path : folders) {
    NamedRun run{.name = run_name(path), .folder = read_description(path)};
    for (const NamedRun& other : runs) {
      if (other.name == run.name)
        throw UsageError(
            fmt::format("dirs = {} (must have another name than {}: tables tell runs apart by it)",
                        path.string(), other.folder.path.string()));
    }
    run.hides_times = why_not_comparable(run.folder.manifest);
    if (run.hides_times.empty() && !runs.empty())
      run.hides_times = machine_difference(runs.front().folder, run.folder).value_or("");
    runs.push_back(std::move(run));
  }
  return runs;
}

/// What the records say of each scene, which must be one scene.
class KnownScenes {
 public:
  /// \throws UsageError where a scene of that name is another one
  void require_same(const Record& record, const NamedRun& run) {
    const auto [known, fresh] = scenes_.try_emplace(record.scene, record.scene_sha256, run.folder.path);
    if (fresh || known->second.first == record.scene_sha256) return;
    throw UsageError(
        fmt::format("{}: scene = {} (must be the same as in {}: its file has changed between the runs)",
                    run.folder.path.string(), record.scene, known->second.second.string()));
  }

 private:
  std::map<std::string, std::pair<std::string, fs::path>> scenes_;
};

Json manifest_of(std::span<const NamedRun> runs) {
  Json manifest = runs.front().folder.manifest;
  Json list = Json::array();
  for (const NamedRun& run : runs) {
    Json entry{{"name", run.name}};
    for (const char* key : {"date", "command_line", "machine", "build"}) {
      if (run.folder.manifest.contains(key)) entry[key] = run.folder.manifest[key];
    }
    if (!run.hides_times.empty()) entry["times_left_out"] = run.hides_times;
    list.push_back(std::move(entry));
    join_plugins(manifest, run.folder.manifest);
  }
  for (const char* key : {"date", "command_line"}) manifest.erase(key);
  manifest["runs"] = std::move(list);
  return manifest;
}

}  // namespace

void put_side_by_side(std::span<const fs::path> folders, const fs::path& out) {
  const std::vector<NamedRun> runs = named_runs(folders);
  make_folder(out);
  KnownScenes scenes;
  std::vector<PlannedCase> plan;
  write_whole(out / "records.jsonl", [&](const TextSink& sink) {
    for (const NamedRun& run : runs) {
      for (Record& record : read_current_records(run.folder.path)) {
        scenes.require_same(record, run);
        record.run = run.name;
        record.case_id += fmt::format(" ({})", run.name);
        record.key = sha256(record.key + "\n" + run.name);
        if (!run.hides_times.empty()) record.seconds.reset();
        plan.push_back({.key = record.key, .case_id = record.case_id, .method = record.method});
        sink(json_text(to_json(record)) + "\n");
      }
    }
  });
  write_whole(out / "manifest.json", json_text(manifest_of(runs), 2) + "\n");
  write_plan(out, plan);
}

std::string times_left_out(const Json& manifest) {
  std::vector<std::string> sentences;
  if (!manifest.contains("runs")) return {};
  for (const Json& run : manifest["runs"]) {
    if (run.contains("times_left_out"))
      sentences.push_back(fmt::format("Times of {} are left out: {}.", run.value("name", "a run"),
                                      run["times_left_out"].get<std::string>()));
  }
  return joined(sentences, " ");
}

}  // namespace signorini
