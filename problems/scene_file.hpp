#pragma once
// TOML scene files -> validated Problem. The format is the contract of docs/scene-format.md.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// A scene file that cannot be used. what() is the one line for the user,
/// `FILE:LINE: field = value (what is required)`; the line is absent where none applies.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The tag of scenes with more than a thousand coordinates or thirty contacts: what visits the whole
/// catalogue by itself, such as a test, leaves them out.
inline constexpr std::string_view kLarge = "large";
/// The tag of scenes whose orbits take minutes to search.
inline constexpr std::string_view kLongSearch = "long-search";

/// What a scene says of itself.
struct SceneHeader {
  std::string name = {};
  std::string title = {};
  std::string reference = {};
  std::vector<std::string> tags = {};

  [[nodiscard]] bool carries(std::string_view tag) const;
};

/// Reads no more than this of a scene file: nothing is assembled, however large the system.
/// \throws SceneError as load_scene does for what it reads
SceneHeader load_header(const std::filesystem::path& path);

/// Reads and validates one scene file.
/// \throws SceneError for a missing or unreadable file, bad TOML, an unknown or missing key, a value
///         out of range, or a Problem that `validate` refuses; the line points at the culprit.
Problem load_scene(const std::filesystem::path& path);

/// The same from text already in memory; `name` stands for the file in messages; the files
/// of matrices that the scene names are looked for in its folder.
Problem parse_scene(std::string_view text, const std::string& name);

/// Folder that holds catalogue/ and suites/: $SIGNORINI_PROBLEMS if set, else the installed or source folder.
/// \throws SceneError if it is gone
std::filesystem::path problems_folder();

/// Every scene file of the catalogue, sorted by name.
std::vector<std::filesystem::path> catalogue_scenes();

/// Path of a scene given by catalogue name ("sdof-stop") or by path to a TOML file.
/// \throws SceneError naming close matches if there is no such scene.
std::filesystem::path find_scene(const std::string& name_or_path);

}  // namespace signorini
