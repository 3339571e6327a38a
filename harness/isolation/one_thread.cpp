#include "harness/isolation/one_thread.hpp"

#include <dlfcn.h>

namespace signorini {

void compute_on_one_thread() {
  // By name: which of them is there is not known before the program runs (Debian's alternatives, plugins).
  for (const char* name : {"omp_set_num_threads", "openblas_set_num_threads", "MKL_Set_Num_Threads",
                           "bli_thread_set_num_threads"}) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym is for
    if (const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, name)); set != nullptr) set(1);
  }
}

}  // namespace signorini
