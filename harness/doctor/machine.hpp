#pragma once
// Properties of this machine that make times unreliable.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// A property of the machine and whether it disturbs times.
struct MachineProperty {
  std::string name = {};    ///< "governor"
  std::string value = {};   ///< "unknown" where the system does not provide it
  bool known = true;        ///< the system provides it
  bool good = true;         ///< as far as is known, it does not disturb times
  std::string advice = {};  ///< its effect on times and a remedy; empty if good
};

/// Properties that the system's files below `root` give (/proc, /sys): governor, turbo, hyper-threading,
/// clock, hypervisor, stolen time, load.
std::vector<MachineProperty> examine_system(const std::filesystem::path& root = "/");

/// Build type, processors that may be used, resolution of the clock, how well a fixed piece of work repeats,
/// and work of other processes; takes about a second.
std::vector<MachineProperty> examine_running();

}  // namespace signorini
