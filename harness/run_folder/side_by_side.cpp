#include "harness/run_folder/side_by_side.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
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
  fs::path place = {};
  RunFolder folder = {};         ///< description alone; its path is the name, for messages and the page
  std::string hides_times = {};  ///< why; empty where its times may stand beside those of the first
  double factor = 1.0;           ///< that its times are multiplied by

  /// Settles what becomes of its times beside those of the first run.
  void stand_beside(const NamedRun& first) {
    const std::optional<std::string> difference = machine_difference(first.folder, folder);
    if (!difference) return;
    const std::optional<double> ratio = times_factor(first.folder.manifest, folder.manifest);
    factor = ratio.value_or(1.0);
    if (!ratio) hides_times = *difference + ", and not both runs have a time of the same calibration solve";
  }
};

std::vector<NamedRun> named_runs(std::span<const fs::path> folders) {
  std::vector<NamedRun> runs;
  for (const fs::path& path : folders) {
    NamedRun run{.name = run_name(path), .place = path, .folder = read_description(path)};
    run.folder.path = run.name;
    for (const NamedRun& other : runs) {
      if (other.name == run.name)
        throw UsageError("dirs = {} (must have another name than {}: tables tell runs apart by it)",
                         path.string(), other.place.string());
    }
    run.hides_times = why_not_comparable(run.folder.manifest);
    if (run.hides_times.empty() && !runs.empty()) run.stand_beside(runs.front());
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
    throw UsageError("{}: scene = {} (must be the same as in {}: its file has changed between the runs)",
                     run.folder.path.string(), record.scene, known->second.second.string());
  }

 private:
  std::map<std::string, std::pair<std::string, fs::path>> scenes_;
};

Json manifest_of(std::span<const NamedRun> runs) {
  Json manifest = runs.front().folder.manifest;
  Json list = Json::array();
  for (const NamedRun& run : runs) {
    Json entry{{"name", run.name}};
    for (const char* key : {"date", "command_line", "machine", "build", "calibration"}) {
      if (run.folder.manifest.contains(key)) entry[key] = run.folder.manifest[key];
    }
    if (!run.hides_times.empty()) entry["times_left_out"] = run.hides_times;
    if (run.factor != 1.0) entry["times_multiplied_by"] = run.factor;
    list.push_back(std::move(entry));
    join_plugins(manifest, run.folder.manifest);
  }
  for (const char* key : {"date", "command_line"}) manifest.erase(key);
  manifest["runs"] = std::move(list);
  return manifest;
}

void multiply(double factor, Seconds& seconds) {
  for (double* time : {&seconds.median, &seconds.min, &seconds.mad, &seconds.setup, &seconds.solve})
    *time *= factor;
  for (TimedRound& round : seconds.rounds) {
    round.setup *= factor;
    round.solve *= factor;
    if (round.first) *round.first *= factor;
  }
  if (seconds.first) *seconds.first *= factor;
  if (seconds.exchange) *seconds.exchange *= factor;
}

}  // namespace

void put_side_by_side(std::span<const fs::path> folders, const fs::path& out) {
  const std::vector<NamedRun> runs = named_runs(folders);
  make_folder(out);
  KnownScenes scenes;
  std::vector<PlannedCase> plan;
  write_whole(out / "records.jsonl", [&](const TextSink& sink) {
    for (const NamedRun& run : runs) {
      for (Record& record : read_current_records(run.place)) {
        scenes.require_same(record, run);
        record.run = run.name;
        record.case_id += fmt::format(" ({})", run.name);
        record.key = sha256(record.key + "\n" + run.name);
        if (!run.hides_times.empty()) record.seconds.reset();
        if (record.seconds) multiply(run.factor, *record.seconds);
        plan.push_back({.key = record.key, .case_id = record.case_id, .method = record.method});
        sink(json_text(to_json(record)) + "\n");
      }
    }
  });
  write_whole(out / "manifest.json", json_text(manifest_of(runs), 2) + "\n");
  write_plan(out, plan);
}

std::string remarks_on_times(const Json& manifest) {
  std::vector<std::string> sentences;
  if (!manifest.contains("runs")) return {};
  for (const Json& run : manifest["runs"]) {
    const std::string name = run.value("name", "a run");
    if (run.contains("times_left_out"))
      sentences.push_back(
          fmt::format("Times of {} are left out: {}.", name, run["times_left_out"].get<std::string>()));
    else if (run.contains("times_multiplied_by"))
      sentences.push_back(
          fmt::format("Times of {} are multiplied by {:.3g}, the ratio of the times of a calibration solve "
                      "on the machine "
                      "of {} and on its own.",
                      name, run["times_multiplied_by"].get<double>(),
                      manifest["runs"].front().value("name", "the first")));
  }
  return joined(sentences, " ");
}

}  // namespace signorini
