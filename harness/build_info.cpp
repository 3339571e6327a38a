#include "harness/build_info.hpp"

#include <algorithm>

#include "harness/files.hpp"
#include "methods/plugin/sanitizer.hpp"

namespace signorini {

bool build_may_be_timed() {
#if defined(NDEBUG) && defined(__OPTIMIZE__)
  return !kAddressSanitizer;
#else
  return false;
#endif
}

std::string code_version(std::string_view method) {
  std::string folder(method);
  std::ranges::replace(folder, '-', '_');
  std::string text;
  for (const auto& [name, hash] : build_info().sources) {
    if (name.empty() || name == folder) text += hash;
  }
  return short_digest(text);
}

}  // namespace signorini
