// Where the shipped scenes are, and how they are found by name.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "problems/files/close_names.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

// Names of all files of scenes that ship.
std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const char* folder : {"catalogue", "families", "populations"}) {
    for (const fs::path& path : shipped_files(folder)) names.push_back(path.stem().string());
  }
  return names;
}

}  // namespace

fs::path problems_folder() {
  if (const char* folder = std::getenv("SIGNORINI_PROBLEMS"); folder != nullptr && *folder != '\0') {
    if (!fs::is_directory(folder)) {
      throw SceneError(
          fmt::format("SIGNORINI_PROBLEMS = {} (must be a folder with a folder catalogue)", folder));
    }
    return folder;
  }
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  fs::path installed = (program.parent_path() / SIGNORINI_INSTALLED_PROBLEMS).lexically_normal();
  if (fs::is_directory(installed, none)) return installed;
  fs::path built = SIGNORINI_PROBLEMS_FOLDER;
  if (!fs::is_directory(built)) {
    throw SceneError(fmt::format(
        "SIGNORINI_PROBLEMS = missing (must name the folder of the scenes: neither {} nor {} is there)",
        installed.string(), built.string()));
  }
  return built;
}

std::vector<fs::path> shipped_files(const char* folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(problems_folder() / folder, none)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files, {}, [](const fs::path& file) { return file.stem().string(); });
  return files;
}

std::vector<SceneSource> shipped_scenes() {
  const std::vector<fs::path> single = shipped_files("catalogue");
  std::vector<SceneSource> scenes(single.begin(), single.end());
  for (const fs::path& file : shipped_files("families")) {
    for (std::string& level : load_levels(file)) scenes.emplace_back(file, std::move(level));
  }
  return scenes;
}

SceneSource find_scene(const std::string& name_or_path) {
  if (is_file(name_or_path)) return fs::path(name_or_path);
  const std::size_t at = name_or_path.rfind('@');
  const std::string base = name_or_path.substr(0, at);
  const std::string level = at == std::string::npos ? "" : name_or_path.substr(at + 1);
  const bool is_path = base.find('/') != std::string::npos || base.ends_with(".toml");
  if (is_path) {
    if (is_file(base)) return {base, level};
  } else {
    for (const char* folder : {"catalogue", "families", "populations"}) {
      fs::path path = problems_folder() / folder / (base + ".toml");
      if (!base.empty() && is_file(path)) return {std::move(path), level};
    }
  }
  const std::string hint = suggestion(fs::path(base).stem().string(), shipped_names());
  std::error_code ignored;
  if (is_path && !fs::exists(base, ignored))
    throw SceneError(fmt::format("scene = {} (must exist: there is no such file{})", name_or_path, hint));
  throw SceneError(
      fmt::format("scene = {} (must be a catalogue scene or a TOML file{})", name_or_path, hint));
}

}  // namespace signorini
