#pragma once
// Methods from outside the tree, from shared objects and commands, added to the catalogue.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// Adds to the catalogue the methods of every *.so and *.toml in the folders that $SIGNORINI_PLUGIN_PATH
/// names, separated by colons, then those of `files`. A file met twice is loaded once. To be called before
/// the catalogue is used, by a process without other threads. \throws UsageError or SceneError, one line, for
/// what cannot be read or loaded, was built otherwise than this program, or cannot be told apart by name
void load_plugins(const std::vector<std::string>& files);

/// The files that load_plugins was given, for commands that are printed or started.
const std::vector<std::string>& given_plugins();

/// All files that load_plugins has loaded, without links and dots.
const std::vector<std::filesystem::path>& loaded_plugins();

}  // namespace signorini
