#pragma once
// Methods from a shared object (methods/plugin/plugin.hpp).

#include <filesystem>
#include <vector>

#include "methods/catalogue.hpp"

namespace signorini {

/// The methods of a plugin, which stays loaded until the program ends. First a child process loads it and
/// makes each method with its defaults and at each step of its ladder, so that one that is built otherwise,
/// crashes or throws there is refused and harms nobody.
/// \throws UsageError, one line, for a file that is no plugin or was built otherwise than this program
std::vector<MethodEntry> load_shared_plugin(const std::filesystem::path& file);

}  // namespace signorini
