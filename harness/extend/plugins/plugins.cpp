#include "harness/extend/plugins/plugins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/extend/plugins/shared_plugin.hpp"
#include "harness/failure.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPath = "SIGNORINI_PLUGIN_PATH";

/// Plugins of a folder, by name.
std::vector<fs::path> plugins_in(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".so" || extension == ".toml") files.push_back(entry.path());
  }
  if (failure) {
    throw UsageError(fmt::format("{} = {} (must name folders that can be read: {})", kPath, folder.string(),
                                 failure.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> plugins_on_path() {
  const char* const variable = std::getenv(kPath);
  std::string_view rest = variable == nullptr ? "" : variable;
  std::vector<fs::path> files;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    if (folder.empty()) continue;
    for (fs::path& file : plugins_in(folder)) files.push_back(std::move(file));
  }
  return files;
}

/// Without links and dots, so that two ways to a file are one. \throws UsageError
fs::path found(const std::string& file) {
  std::error_code failure;
  fs::path path = fs::canonical(file, failure);
  if (failure || !fs::is_regular_file(path, failure)) {
    throw UsageError(fmt::format(
        "plugin = {} (must be a file: a shared object, or a command's description *.toml)", file));
  }
  return path;
}

void load_plugin(const fs::path& file) {
  std::vector<MethodEntry> entries;
  if (file.extension() == ".toml") {
    entries.push_back(load_command_method(file));
  } else {
    entries = load_shared_plugin(file);
  }
  for (MethodEntry& entry : entries) {
    try {
      add_method(std::move(entry));
    } catch (const InvalidOption& error) {
      throw UsageError(fmt::format("{}: {}", file.string(), error.what()));
    }
  }
}

}  // namespace

void load_plugins(const std::vector<std::string>& files) {
  std::vector<fs::path> plugins;
  const auto add = [&](const std::string& file) {
    fs::path plugin = found(file);
    if (std::find(plugins.begin(), plugins.end(), plugin) == plugins.end())
      plugins.push_back(std::move(plugin));
  };
  for (const fs::path& file : plugins_on_path()) add(file.string());
  for (const std::string& file : files) add(file);
  for (const fs::path& plugin : plugins) load_plugin(plugin);
}

}  // namespace signorini
