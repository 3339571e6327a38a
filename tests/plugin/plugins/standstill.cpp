// Compiled several times, once as it should be and else with flags that a plugin must not have.
#ifdef TINY_HEADERS
#include "methods/plugin/interface.hpp"
#undef SIGNORINI_HEADERS
#define SIGNORINI_HEADERS TINY_HEADERS
#endif

#include "tiny.hpp"

#ifdef TINY_API
#undef SIGNORINI_PLUGIN_API
#define SIGNORINI_PLUGIN_API TINY_API
#endif
#ifndef TINY_NAME
#define TINY_NAME "tiny"
#endif

namespace tiny {

struct Plain final : Method<StandStill> {
  static constexpr signorini::MethodText kText = text_of(TINY_NAME);
  using Method::Method;
};

}  // namespace tiny

SIGNORINI_PLUGIN(tiny::Plain)
