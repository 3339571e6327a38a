#pragma once
// TOML scene files -> validated Problem. The format is the contract of docs/scene-format.md.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "problems/files/load_table.hpp"
#include "problems/problem.hpp"
#include "problems/scene/scene_family.hpp"

namespace signorini {

/// The tag of scenes with more than a thousand coordinates or thirty contacts: what visits the whole
/// catalogue by itself, such as a test, leaves them out.
inline constexpr std::string_view kLarge = "large";
/// The tag of scenes whose orbits take minutes to search.
inline constexpr std::string_view kLongSearch = "long-search";

/// Largest scene file that is read [bytes]: a scene is text written by hand.
inline constexpr std::size_t kLargestScene = std::size_t{1} << 24U;

/// Where a scene is read from: a file, and for one of a family its level, for one that is drawn seed and
/// number.
struct SceneSource {
  /// A file that is a scene by itself unless a level is given.
  SceneSource(std::filesystem::path scene_file, std::string level_label = {})  // NOLINT: a file is a source
      : file(std::move(scene_file)), level(std::move(level_label)) {}
  std::filesystem::path file;  ///< TOML
  std::string level;  ///< label of its level, "1e-4", or instance, "7-3"; empty for a scene by itself
  /// Member by member.
  bool operator==(const SceneSource&) const = default;
};

/// The description at the head of a scene file.
struct SceneHeader {
  std::string name = {};                       ///< "sdof-stop"; of a family's scene "grazing@1e-4"
  std::string title = {};                      ///< one line for people
  std::string reference = {};                  ///< where the scene comes from
  std::vector<std::string> tags = {};          ///< free words
  std::optional<FamilyLevel> family = {};      ///< where the scene is one of a family
  std::optional<SceneInstance> instance = {};  ///< where its numbers are drawn

  /// True if the scene has this tag.
  [[nodiscard]] bool carries(std::string_view tag) const;
};

/// Reads no more than this of a scene file: nothing is assembled, however large the system.
/// \throws SceneError as load_scene does for what it reads
SceneHeader load_header(const SceneSource& source);

/// Whether a scene file has ranges to draw instances from. \throws SceneError
bool offers_instances(const std::filesystem::path& path);

/// Labels of the levels of a family's file, easiest first; empty for a scene by itself. \throws SceneError
std::vector<std::string> load_levels(const std::filesystem::path& path);

/// Reads and validates one scene file.
/// \throws SceneError for a missing or unreadable file, bad TOML, an unknown or missing key, a value
///         out of range, or a Problem that `validate` refuses; the line points at the culprit.
Problem load_scene(const SceneSource& source);

/// Reads and validates a scene from text in memory; `name` stands for the file in messages; the files
/// of matrices that the scene names are looked for in its folder; `level` chooses the scene of a family.
Problem parse_scene(std::string_view text, const std::string& name, std::string_view level = {});

/// A scene, and what else makes it that scene.
struct SceneWithSources {
  Problem problem = {};                           ///< validated
  std::optional<FamilyLevel> family = {};         ///< where it is one of a family
  std::optional<SceneInstance> instance = {};     ///< where its numbers are drawn
  std::vector<std::filesystem::path> files = {};  ///< of matrices and samples that it is read from
  std::vector<SampledLoad> sampled_loads = {};    ///< loads given by samples
};

/// parse_scene, with the sources of the scene.
SceneWithSources parse_scene_with_sources(std::string_view text, const std::string& name,
                                          std::string_view level = {});

// The steps between a file and its Problem, for readers that change the document in between.

/// All text of a scene file. \throws SceneError where it is missing, unreadable or too large
std::string read_scene_text(const std::filesystem::path& path);

/// How much of a scene is checked.
enum class SceneChecks {
  all,      ///< as load_scene does
  reading,  ///< the document, but not whether its numbers make a scene
};

/// The scene of a document.
/// \param name    of the file, in messages
/// \param variant  what choose_variant has made of it
/// \throws SceneError as parse_scene does
SceneWithSources read_scene_document(const TomlNode& document, const std::string& name,
                                     const SceneVariant& variant, SceneChecks checks = SceneChecks::all);

/// Folder that holds catalogue/, families/, populations/ and suites/: $SIGNORINI_PROBLEMS if set; else the
/// one installed with the program that runs, in share/signorini; else that of the sources. \throws SceneError
/// if it is gone
std::filesystem::path problems_folder();

/// Every TOML file in one of its folders, "catalogue", "families", "populations" or "suites", sorted by name.
std::vector<std::filesystem::path> shipped_files(const char* folder);

/// All scenes that ship: the catalogue, then those of every family file, each family from easy to hard.
/// \throws SceneError for a family file that cannot be used
std::vector<SceneSource> shipped_scenes();

/// A scene given by name ("sdof-stop", of a family "grazing@1e-4", drawn "one-mass-spring@7-3") or by path to
/// a TOML file ("own.toml", "own.toml@1e-4"). \throws SceneError naming close matches if there is no such
/// scene.
SceneSource find_scene(const std::string& name_or_path);

}  // namespace signorini
