#include "harness/isolation/process_state.hpp"

#include <dlfcn.h>

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <limits>

namespace signorini {

namespace {

/// What is called; std::signal changes the flags, which nobody misses.
bool same_handler(const struct sigaction& a, const struct sigaction& b) {
  return a.sa_handler == b.sa_handler;
}

}  // namespace

bool floating_point_is_usual() {
  const volatile double smallest = std::numeric_limits<double>::min();
  return std::fegetround() == FE_TONEAREST && smallest / 2.0 > 0.0;
}

void compute_on_one_thread() {
  // What is loaded later, by a plugin for itself, reads these when it is.
  for (const char* variable :
       {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS"})
    setenv(variable, "1", 1);
  // By name: which of them is there is not known before the program runs (Debian's alternatives).
  for (const char* name : {"omp_set_num_threads", "openblas_set_num_threads", "MKL_Set_Num_Threads"}) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym is for
    if (const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, name)); set != nullptr) set(1);
  }
}

ProcessState::ProcessState() {
  std::fegetenv(&floating_point_);
  for (int signal = 1; signal < kSignals; ++signal)
    sigaction(signal, nullptr, &handlers_[static_cast<std::size_t>(signal)]);
}

std::string ProcessState::restore() const {
  const bool rounding = !floating_point_is_usual();
  std::fesetenv(&floating_point_);
  bool handlers = false;
  for (int signal = 1; signal < kSignals; ++signal) {
    const struct sigaction& before = handlers_[static_cast<std::size_t>(signal)];
    struct sigaction now {};
    // The system refuses to tell or set those of SIGKILL and SIGSTOP, which nobody can change.
    if (sigaction(signal, nullptr, &now) != 0 || same_handler(now, before)) continue;
    handlers = sigaction(signal, &before, nullptr) == 0 || handlers;
  }
  const std::string numbers = rounding ? "the rounding of numbers" : "";
  if (!handlers) return numbers;
  return numbers.empty() ? "signal handlers" : numbers + " and signal handlers";
}

}  // namespace signorini
