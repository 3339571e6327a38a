#include "harness/doctor/machine.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "harness/build_info.hpp"
#include "harness/doctor/calibration.hpp"
#include "harness/files.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Unknown where the value is empty.
MachineProperty property(std::string name, std::string value, bool good, std::string advice) {
  if (value.empty()) return {.name = std::move(name), .value = "unknown", .known = false};
  return {.name = std::move(name),
          .value = std::move(value),
          .good = good,
          .advice = good ? "" : std::move(advice)};
}

MachineProperty governor(const fs::path& root) {
  const std::string value = clock_governor(root);
  return property("governor", value, value == "performance",
                  "the clock frequency follows the load; set the governor to performance");
}

MachineProperty turbo(const fs::path& root) {
  const std::string intel = first_line(root / "sys/devices/system/cpu/intel_pstate/no_turbo");
  const std::string boost = first_line(root / "sys/devices/system/cpu/cpufreq/boost");
  const bool on = intel.empty() ? boost == "1" : intel == "0";
  return property("turbo",
                  (intel + boost).empty() ? ""
                  : on                    ? "on"
                                          : "off",
                  !on, "the clock frequency depends on temperature and on the other cores; switch turbo off");
}

MachineProperty simultaneous_threads(const fs::path& root) {
  const std::string active = first_line(root / "sys/devices/system/cpu/smt/active");
  const bool on = active == "1";
  return property("hyper-threading (SMT)",
                  active.empty() ? ""
                  : on           ? "on"
                                 : "off",
                  !on, "two threads share a core and its caches; leave every second one idle");
}

MachineProperty clock_source(const fs::path& root) {
  const std::string value =
      first_line(root / "sys/devices/system/clocksource/clocksource0/current_clocksource");
  const bool good = value == "tsc" || value == "kvm-clock" || value == "arch_sys_counter";
  return property("clock source", value, good, "reading the clock is slow with this one");
}

MachineProperty hypervisor(const fs::path& root) {
  std::ifstream info(root / "proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("flags") && (line + " ").find(" hypervisor ") != std::string::npos)
      return property("virtual machine", "yes", false,
                      "other virtual machines on the host may take processor and cache at any moment");
  }
  return property("virtual machine", "no", true, "");
}

/// Time in which a virtual processor had to wait for a real one, since the start of the system.
MachineProperty stolen_time(const fs::path& root) {
  std::istringstream line(first_line(root / "proc/stat"));
  std::string cpu;
  line >> cpu;
  std::vector<double> ticks;
  for (double value = 0.0; line >> value;) ticks.push_back(value);
  constexpr std::size_t kSteal = 7;
  if (ticks.size() <= kSteal) return property("stolen time", "", true, "");
  double all = 0.0;
  for (std::size_t i = 0; i <= kSteal; ++i) all += ticks[i];
  const double percent = all > 0.0 ? 100.0 * ticks[kSteal] / all : 0.0;
  return property("stolen time", fmt::format("{:.1f} %", percent), percent < 1.0,
                  "the host gave the processor to others; use another host or more rounds");
}

MachineProperty load(const fs::path& root) {
  const std::string line = first_line(root / "proc/loadavg");
  const double value = std::strtod(line.c_str(), nullptr);
  return property("load", line.empty() ? "" : fmt::format("{:.2f} over the last minute", value), value < 0.3,
                  "other processes are at work; stop them or wait");
}

MachineProperty build_type() {
  return property("build", std::string(build_info().build_type), build_may_be_timed(),
                  "this build records no times; build with the preset release");
}

MachineProperty clock_resolution() {
  double least = 1.0;
  for (int i = 0; i < 1000; ++i) {
    const auto begin = Clock::now();
    auto end = Clock::now();
    while (end == begin) end = Clock::now();
    least = std::min(least, std::chrono::duration<double>(end - begin).count());
  }
  return property("clock resolution", fmt::format("{:.0f} ns", 1e9 * least), least < 1e-6,
                  "short work cannot be measured");
}

double seconds_of_fixed_work() {
  const auto begin = Clock::now();
  const volatile double last = calibration_solve().back();
  static_cast<void>(last);
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

MachineProperty repeatability() {
  std::vector<double> seconds;
  for (int i = 0; i < 100; ++i) seconds.push_back(seconds_of_fixed_work());
  const double middle = median(seconds), deviation = median_deviation(seconds) / middle;
  return property(
      "repeatability",
      fmt::format("{:.1f} % of {:.3g} ms, the calibration solve", 100.0 * deviation, 1e3 * middle),
      deviation < 0.02, "equal work takes unequal times; see the other lines");
}

MachineProperty usable_processors() {
  cpu_set_t set;
  const int usable = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
  return property("processors", fmt::format("{} of {} may be used", usable, sysconf(_SC_NPROCESSORS_ONLN)),
                  usable > 1,
                  "the harness and the system disturb what is timed; leave them a processor of their own");
}

struct ProcessTime {
  std::string name;
  long ticks = 0;
};

/// Processor time of every other process so far, by number.
std::map<int, ProcessTime> process_times() {
  std::map<int, ProcessTime> times;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator("/proc", none)) {
    const int id = std::atoi(entry.path().filename().c_str());
    if (id <= 0 || id == getpid()) continue;
    const std::string line = first_line(entry.path() / "stat");
    const std::size_t open = line.find('('), close = line.rfind(')');
    if (open == std::string::npos || close == std::string::npos) continue;
    std::istringstream rest(line.substr(close + 2));
    std::string word;
    constexpr int kBeforeTimes = 11;  // fields between the name and utime, see proc(5)
    for (int i = 0; i < kBeforeTimes; ++i) rest >> word;
    long user = 0, system = 0;
    rest >> user >> system;
    times[id] = {line.substr(open + 1, close - open - 1), user + system};
  }
  return times;
}

MachineProperty other_work() {
  constexpr std::chrono::milliseconds kWatch(500);
  const auto before = process_times();
  std::this_thread::sleep_for(kWatch);
  long all = 0, most = 0;
  std::string busiest;
  for (const auto& [id, now] : process_times()) {
    const auto known = before.find(id);
    const long ticks = now.ticks - (known == before.end() ? 0 : known->second.ticks);
    all += ticks;
    if (ticks > most) {
      most = ticks;
      busiest = now.name;
    }
  }
  const double seconds = static_cast<double>(all) / static_cast<double>(sysconf(_SC_CLK_TCK));
  const double share = seconds / std::chrono::duration<double>(kWatch).count();
  return property(
      "other processes",
      busiest.empty() ? "idle" : fmt::format("{:.0f} % of a processor, most by `{}`", 100.0 * share, busiest),
      share < 0.05, "they take processor, cache and memory; stop them");
}

}  // namespace

std::vector<MachineProperty> examine_system(const fs::path& root) {
  return {governor(root),    turbo(root), simultaneous_threads(root), clock_source(root), hypervisor(root),
          stolen_time(root), load(root)};
}

std::vector<MachineProperty> examine_running() {
  return {build_type(), usable_processors(), clock_resolution(), repeatability(), other_work()};
}

}  // namespace signorini
