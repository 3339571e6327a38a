#pragma once
// What of this machine makes times unreliable.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// One thing looked at.
struct Finding {
  std::string name = {};    ///< "governor"
  std::string value = {};   ///< what was found; "unknown" where the system does not tell
  bool known = true;        ///< the system tells
  bool good = true;         ///< nothing here disturbs times, as far as is known
  std::string advice = {};  ///< what it does to times and what to do about it; empty if good
};

/// What the files of the system below `root` say (/proc, /sys): governor, turbo, simultaneous threads, clock,
/// hypervisor, stolen time, load.
std::vector<Finding> examine_system(const std::filesystem::path& root = "/");

/// Build type, processors that may be used, resolution of the clock, how well a fixed piece of work repeats,
/// and work of other processes; takes about a second.
std::vector<Finding> examine_running();

}  // namespace signorini
