// Where the shipped scenes are, and how they are found by name.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "problems/scene_file.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSuggestions = 3;

// Levenshtein's distance: the fewest insertions, deletions and replacements.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

// Names that a slip of the fingers may have meant, nearest first.
std::vector<std::string> close_names(const std::string& name) {
  const std::size_t farthest = std::max<std::size_t>(2, name.size() / 4);
  std::vector<std::pair<std::size_t, std::string>> close;
  for (const fs::path& path : catalogue_scenes()) {
    const std::string known = path.stem().string();
    const std::size_t distance = edit_distance(name, known);
    if (distance <= farthest) close.emplace_back(distance, known);
  }
  std::sort(close.begin(), close.end());
  std::vector<std::string> names;
  for (const auto& [distance, known] : close) {
    if (names.size() < kMostSuggestions) names.push_back(known);
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
  fs::path built = SIGNORINI_PROBLEMS_FOLDER;
  if (!fs::is_directory(built)) {
    throw SceneError(fmt::format(
        "SIGNORINI_PROBLEMS = missing (must name the folder of the scenes: {} is gone)", built.string()));
  }
  return built;
}

std::vector<fs::path> catalogue_scenes() {
  std::vector<fs::path> scenes;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(problems_folder() / "catalogue", none)) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const fs::path& a, const fs::path& b) { return a.stem().string() < b.stem().string(); });
  return scenes;
}

fs::path find_scene(const std::string& name_or_path) {
  const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
  fs::path path =
      is_path ? fs::path(name_or_path) : problems_folder() / "catalogue" / (name_or_path + ".toml");
  std::error_code ignored;
  if (!name_or_path.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return path;
  const std::vector<std::string> close = close_names(fs::path(name_or_path).stem().string());
  const std::string hint = close.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(close, ", "));
  throw SceneError(
      fmt::format("scene = {} (must be a catalogue scene or a TOML file{})", name_or_path, hint));
}

}  // namespace signorini
