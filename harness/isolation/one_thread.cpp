#include "harness/isolation/one_thread.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <initializer_list>

namespace signorini {

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

}  // namespace signorini
