#include "harness/reduction/free_memory.hpp"

#include <fstream>
#include <limits>
#include <string>

namespace signorini {

double free_memory() {
  constexpr double kKilobyte = 1024.0;
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    double value = 0.0;
    if (word == "MemAvailable:" && file >> value) return kKilobyte * value;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace signorini
