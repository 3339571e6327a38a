#include "harness/extend/plugins/plugins.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/isolation/process_state.hpp"
#include "harness/plan/plan.hpp"
#include "harness/text/words.hpp"
#include "methods/catalogue.hpp"
#include "methods/plugin/plugin.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPath = "SIGNORINI_PLUGIN_PATH";

/// Removes the text up to the separator, and the separator, from the front. \return that text
std::string_view take(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

/// Plugins of a folder, by name.
std::vector<fs::path> plugins_in(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".so" || extension == ".toml") files.push_back(entry.path());
  }
  if (failure) {
    throw UsageError("{} = {} (must name folders that can be read: {})", kPath, folder.string(),
                     failure.message());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<fs::path> plugins_on_path() {
  std::vector<fs::path> files;
  for (const std::string& folder : folders_of(kPath)) {
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
    throw UsageError("plugin = {} (must be a file: a shared object, or a command's description *.toml)",
                     file);
  }
  return path;
}

/// Limit of loading a plugin and making its methods, which usually takes milliseconds [s].
constexpr double kProbeSeconds = 20.0;

[[noreturn]] void refuse(const fs::path& file, std::string_view requirement) {
  throw UsageError("plugin = {} ({})", file.string(), requirement);
}

/// "EIGEN_MAX_ALIGN_BYTES is 32 there, 16 here": the first item in which two texts of kPluginAbi differ.
std::string abi_difference(std::string_view there, std::string_view here) {
  while (!there.empty() || !here.empty()) {
    std::string_view theirs = take(there, ';'), ours = take(here, ';');
    if (theirs == ours) continue;
    const std::string_view item = take(theirs, '='), our_item = take(ours, '=');
    if (item != our_item) return "other items make up its ABI tag";
    return fmt::format("{} is {} there, {} here", item, theirs, ours);
  }
  return {};
}

/// What the entry point returns, once all that must be equal is found to be. \throws UsageError
const PluginDescription& open_plugin(const fs::path& file) {
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    std::string reason = dlerror();
    if (reason.starts_with(file.string() + ": ")) reason.erase(0, file.string().size() + 2);
    refuse(file, "must be a shared object that can be loaded: " + reason);
  }
  if (!floating_point_is_usual())
    refuse(file,
           "must leave floating-point numbers as they are; linked with -ffast-math it changes them for all "
           "methods");
  const auto entry_point = reinterpret_cast<PluginEntryPoint>(dlsym(handle, kPluginEntryPoint));
  if (entry_point == nullptr)
    refuse(file, fmt::format("must be a plugin: it has no function {}", kPluginEntryPoint));
  const PluginDescription* const description = entry_point();
  if (description == nullptr) refuse(file, "must describe itself: its entry point returns nothing");
  if (description->api != SIGNORINI_PLUGIN_API)
    refuse(file,
           fmt::format("must be built for plugin API {}, not {}", SIGNORINI_PLUGIN_API, description->api));
  if (description->abi == nullptr || std::string_view(description->abi) != kPluginAbi) {
    refuse(file,
           fmt::format("must be built as this program is: {}; build it anew with the installed package",
                       abi_difference(description->abi == nullptr ? "" : description->abi, kPluginAbi)));
  }
  return *description;
}

std::string text_of(const PluginText& text) { return {text.data, text.size}; }

std::vector<MethodEntry> entries_of(const PluginDescription& description) {
  std::vector<MethodEntry> entries;
  for (std::size_t i = 0; i < description.count; ++i) {
    const PluginMethod& method = description.methods[i];
    entries.push_back({.name = text_of(method.name),
                       .title = text_of(method.title),
                       .laws = text_of(method.laws),
                       .ladder = text_of(method.ladder),
                       .order = method.order > 0.0 ? std::optional(method.order) : std::nullopt,
                       .make =
                           [&method](std::span<const OptionSetting> settings) {
                             return std::unique_ptr<Method>(method.make(settings.data(), settings.size()));
                           },
                       .untimed = description.optimised == 1
                                      ? ""
                                      : "the plugin is built without optimisation or with assertions"});
  }
  return entries;
}

/// Loads the plugin and makes its methods. \throws UsageError
void try_plugin(const fs::path& file) {
  for (const MethodEntry& entry : entries_of(open_plugin(file))) {
    try {
      static_cast<void>(entry.make({})->options());
      for (const Settings& settings : ladder_of(entry)) static_cast<void>(entry.make(settings));
    } catch (...) {
      refuse(file, fmt::format("must make its method {} with its defaults and its ladder: {}", entry.name,
                               current_exception_text()));
    }
  }
}

/// The methods of a shared object (methods/plugin/plugin.hpp), which stays loaded until the program ends.
/// First a child process loads it and makes each method with its defaults and at each step of its ladder, so
/// that one that is built otherwise, crashes or throws there is refused and harms nobody. \throws UsageError
std::vector<MethodEntry> load_shared_plugin(const fs::path& file) {
  const std::string hash = sha256_of_file(file);
  const ChildEnd end =
      run_isolated([&](const LineSender&) { try_plugin(file); }, {.stage_seconds = {kProbeSeconds}});
  if (end.kind == ChildEnd::Kind::threw) throw UsageError(end.detail);
  if (end.kind != ChildEnd::Kind::finished)
    refuse(file, "must load and make its methods; in a trial " + describe(end));
  std::vector<MethodEntry> entries = entries_of(open_plugin(file));
  for (MethodEntry& entry : entries) entry.plugin = hash;
  return entries;
}

// Of the whole program, as the catalogue of methods is.
std::vector<std::string> given;
std::vector<fs::path> loaded;

void load_plugin(const fs::path& file) {
  const bool described = file.extension() == ".toml";
  for (MethodEntry& entry : described ? std::vector{load_command_method(file)} : load_shared_plugin(file)) {
    try {
      add_method(std::move(entry));
    } catch (const InvalidOption& error) {
      throw UsageError("{}: {}", file.string(), error.what());
    }
  }
}

}  // namespace

const std::vector<std::string>& given_plugins() { return given; }

const std::vector<fs::path>& loaded_plugins() { return loaded; }

void load_plugins(const std::vector<std::string>& files) {
  given = files;
  loaded.clear();
  const auto add = [&](const std::string& file) {
    fs::path plugin = found(file);
    if (std::ranges::find(loaded, plugin) == loaded.end()) loaded.push_back(std::move(plugin));
  };
  for (const fs::path& file : plugins_on_path()) add(file.string());
  for (const std::string& file : files) add(file);
  for (const fs::path& plugin : loaded) load_plugin(plugin);
}

}  // namespace signorini
