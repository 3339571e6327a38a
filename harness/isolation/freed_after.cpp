#include "harness/isolation/freed_after.hpp"

#include <dlfcn.h>
#include <mimalloc.h>

namespace signorini {

namespace {

constexpr mi_option_t kDelay = mi_option_decommit_delay;

// By name: tests and sanitizers are linked with another allocator.
template <class Function>
Function* function_of_allocator(const char* name) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym is for
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

void set_delay(long milliseconds) {
  if (const auto set = function_of_allocator<void(mi_option_t, long)>("mi_option_set"); set != nullptr)
    set(kDelay, milliseconds);
}

}  // namespace

FreedAfter::FreedAfter(long milliseconds) {
  if (const auto get = function_of_allocator<long(mi_option_t)>("mi_option_get"); get != nullptr)
    before_ = get(kDelay);
  set_delay(milliseconds);
}

FreedAfter::~FreedAfter() { set_delay(before_); }

}  // namespace signorini
