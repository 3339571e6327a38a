#include "harness/run_folder/machine_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "harness/files.hpp"
#include "harness/run_folder/manifest_check.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// The processors and cases of a run whose load is judged.
struct Occupied {
  int processors = 1, jobs = 1;

  /// "the load average was 3.1 at the start, on 2 processors with 1 case at a time"; empty where the load
  /// left the cases alone.
  [[nodiscard]] std::string remark(double load, int own, const char* when) const {
    if (!(load_share(load, own, jobs, processors) > 1.0)) return {};
    return fmt::format("the load average was {:.2g} {}, on {} processor{} with {} case{} at a time", load,
                       when, processors, processors == 1 ? "" : "s", jobs, jobs == 1 ? "" : "s");
  }
};

/// The first number of a list; nothing where there is none.
std::optional<double> first_of(const Json& object, const char* key) {
  if (!object.contains(key) || !object[key].is_array() || object[key].empty()) return std::nullopt;
  return object[key].front().get<double>();
}

/// \param object  with `load`, `running` and `load_end`, as far as they are known
std::string remark_on(const Json& object, const Occupied& machine) {
  if (std::optional<double> load = first_of(object, "load")) {
    if (object.contains("running")) *load = std::min(*load, object["running"].get<double>());
    if (std::string text = machine.remark(*load, 0, "at the start"); !text.empty()) return text;
  }
  const std::optional<double> load = first_of(object, "load_end");
  return load ? machine.remark(*load, machine.jobs, "at the end") : std::string();
}

}  // namespace

std::optional<LoadAverage> load_average(const std::filesystem::path& root) {
  std::ifstream file(root / "proc/loadavg");  // "0.20 0.18 0.12 1/80 11206"
  LoadAverage load;
  double five = 0.0, fifteen = 0.0;
  if (!(file >> load.minute >> five >> fifteen >> load.running)) return std::nullopt;
  load.running = std::max(0, load.running - 1);
  return load;
}

double load_share(double load, int own, int jobs, int processors) {
  constexpr double kLeastFree = 0.25;
  return std::max(0.0, load - own) / std::max(static_cast<double>(processors - jobs), kLeastFree);
}

std::optional<double> load_beside(int jobs) {
  const std::optional<LoadAverage> load = load_average();
  if (!load) return std::nullopt;
  return load_share(load->minute, jobs, jobs, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string why_not_comparable(const Json& manifest) {
  if (!manifest.is_object()) return {};
  if (manifest.contains("times_not_comparable")) return manifest["times_not_comparable"].get<std::string>();
  const Json none = Json::object();
  const Json& machine = manifest.contains("machine") ? manifest["machine"] : none;
  const Occupied occupied{.processors = machine.value("processors", 1), .jobs = manifest.value("jobs", 1)};
  if (manifest.contains("build") && !manifest["build"].value("timings_count", true))
    return "the build is not one that is timed";
  if (occupied.jobs > 1) return fmt::format("{} cases ran at the same time", occupied.jobs);
  if (!machine.contains("processors"))
    return manifest.value("times_comparable", true) ? "" : "its manifest says so";
  if (std::string text = remark_on(machine, occupied); !text.empty()) return text;
  if (manifest.contains("shards")) {
    for (const Json& shard : manifest["shards"])
      if (std::string text = remark_on(shard, occupied); !text.empty()) return text;
  }
  return manifest.value("times_comparable", true) ? "" : "its manifest says so";
}

std::optional<double> times_factor(const Json& there, const Json& here) {
  static const Json::json_pointer kVersion("/calibration/version"), kSeconds("/calibration/seconds");
  for (const Json* manifest : {&there, &here})
    if (!manifest->contains(kVersion) || !manifest->contains(kSeconds)) return std::nullopt;
  if (there.at(kVersion) != here.at(kVersion)) return std::nullopt;
  constexpr double kMost = 1e6;
  const double factor = there.at(kSeconds).get<double>() / here.at(kSeconds).get<double>();
  return factor <= kMost && factor * kMost >= 1.0 ? std::optional(factor) : std::nullopt;
}

void note_times(Json& manifest, const std::string& before) {
  manifest.erase("times_not_comparable");
  manifest["times_comparable"] = true;
  std::string why = why_not_comparable(manifest);
  if (why.empty()) why = before;
  if (why.empty()) return;
  manifest["times_comparable"] = false;
  manifest["times_not_comparable"] = why;
}

void close_manifest(const std::filesystem::path& folder, const std::string& start) {
  const std::filesystem::path file = folder / "manifest.json";
  Json manifest = read_manifest(file);
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) == 3) manifest["machine"]["load_end"] = load;
  const std::string before = why_not_comparable(manifest);
  note_times(manifest, before.empty() ? start : before);
  write_whole(file, json_text(manifest, 2) + "\n");
}

}  // namespace signorini
