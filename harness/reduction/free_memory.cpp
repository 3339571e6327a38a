#include "harness/reduction/free_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace signorini {
namespace {

namespace fs = std::filesystem;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// The number after that word of a file; `absent` where there is none.
double number_after(const fs::path& path, std::string_view name, double absent) {
  std::ifstream file(path);
  for (std::string word; file >> word;) {
    double value = 0.0;
    if (word == name && file >> value) return value;
  }
  return absent;
}

/// The number that a file consists of; `absent` where it is another word, such as `max`, or there is no file.
double number_of_file(const fs::path& path, double absent) {
  double value = 0.0;
  return std::ifstream(path) >> value ? value : absent;
}

/// The files of a control group that bound its memory: as version 1 and version 2 name them.
struct GroupFiles {
  const char* limit;
  const char* taken;
  const char* dropped;  ///< of memory.stat: what is in use and can be had back
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

/// What is left of the limits of a group and of those that it is in, up to the one mounted at `mount`. A
/// container shows its own group there, whatever it is called outside.
double left_of_groups(const fs::path& mount, const std::string& group, const GroupFiles& files) {
  double left = kUnbounded;
  for (fs::path inner = fs::path(group).relative_path();; inner = inner.parent_path()) {
    const fs::path folder = inner.empty() ? mount : mount / inner;
    const double limit = number_of_file(folder / files.limit, kUnbounded);
    const double taken =
        number_of_file(folder / files.taken, 0.0) - number_after(folder / "memory.stat", files.dropped, 0.0);
    left = std::min(left, std::max(0.0, limit - taken));
    if (inner.empty()) return left;
  }
}

}  // namespace

double free_memory(const fs::path& root) {
  double least = 1024.0 * number_after(root / "proc/meminfo", "MemAvailable:", kUnbounded);
  // Lines "NUMBER:CONTROLLERS:GROUP"; of version 2 without controllers.
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':');
    const auto second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    const fs::path mount = root / "sys/fs/cgroup";
    if (controllers == ",,") least = std::min(least, left_of_groups(mount, group, kVersion2));
    if (controllers.find(",memory,") != std::string::npos)
      least = std::min(least, left_of_groups(mount / "memory", group, kVersion1));
  }
  return least;
}

}  // namespace signorini
