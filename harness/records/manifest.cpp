#include "harness/records/manifest.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "harness/build_info.hpp"
#include "harness/records/json_fields.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

std::string kernel_release() {
  utsname names{};
  return uname(&names) == 0 ? names.release : "";
}

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

Json machine() {
  Json json = Json::object();
  write_field(json, Field{"cpu"}, cpu_model());
  json["processors"] = std::thread::hardware_concurrency();
  write_field(json, Field{"governor"}, clock_governor());
  write_field(json, Field{"kernel"}, kernel_release());
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) == 3) json["load"] = load;
  return json;
}

Json build() {
  const BuildInfo& info = build_info();
  Json json{{"version", info.version}};
  if (!info.commit.empty()) {
    json["commit"] = info.commit;
    json["dirty"] = info.dirty;
  }
  json["compiler"] = info.compiler;
  json["flags"] = info.flags;
  json["build_type"] = info.build_type;
  json["timings_count"] = build_may_be_timed();
  json["libraries"] = Json::object();
  for (const auto& [name, version] : info.libraries)
    write_field(json["libraries"], Field{std::string(name).c_str()}, std::string(version));
  json["sources"] = Json::object();
  for (const auto& [name, hash] : info.sources)
    json["sources"][name.empty() ? "common" : std::string(name)] = hash;
  return json;
}

}  // namespace

std::string clock_governor(const std::filesystem::path& root) {
  std::ifstream file(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  std::string line;
  std::getline(file, line);
  return line;
}

Json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                   const std::vector<std::string>& command_line) {
  return {{"schema", 1},
          {"suite", suite.name},
          {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"command_line", command_line},
          {"order", "scene by scene, rounds in random order"},
          {"seed", schedule.seed},
          {"jobs", schedule.together()},
          {"times_comparable", build_may_be_timed() && schedule.together() == 1},
          {"limits",
           {{"timeout_s", limits.timeout},
            {"memory_mb", limits.memory_mb},
            {"repetitions", limits.repetitions},
            {"certificate_timeout_s", limits.certificate_timeout},
            {"reference_timeout_s", limits.reference_timeout}}},
          {"build", build()},
          {"machine", machine()}};
}

}  // namespace signorini
