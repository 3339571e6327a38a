#include "tests/support/child.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>

#include "methods/plugin/sanitizer.hpp"

namespace signorini::test {

namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double mapped_bytes() {
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void limit_address_space(double more_megabytes) {
  const auto bytes = static_cast<rlim_t>(mapped_bytes() + more_megabytes * kMegabyte);
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(2);
}

}  // namespace

ChildCost run_in_child(const std::function<void()>& work, std::optional<double> more_megabytes) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    if (more_megabytes && !kAddressSanitizer) limit_address_space(*more_megabytes);
    try {
      work();
    } catch (const std::exception&) {
      _exit(1);
    }
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  rusage used{};
  const bool ended = child > 0 && wait4(child, &status, 0, &used) == child;
  return {ended && status == 0, seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
          static_cast<double>(used.ru_maxrss) / 1024.0};
}

}  // namespace signorini::test
