#pragma once
// Which scenes: those that ship by name, and one's own by file, folder or glob of files.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/plan/suite.hpp"
#include "problems/problem.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

/// A scene ready to run.
struct Scene {
  Problem problem;
  std::string sha256 = {};  ///< of the scene file, the level of one of a family or the instance, its matrices
                            ///< and sampled loads
  std::optional<FamilyLevel> family = {};
  std::optional<SceneInstance> instance = {};   ///< where its numbers are drawn
  std::vector<SampledLoad> sampled_loads = {};  ///< loads given by samples
  std::string word = {};  ///< what a command calls it: its name, or the path of a file that does not ship
};

/// Reads a scene. \throws SceneError
Scene read_scene(const SceneSource& source);

/// Scene::sha256 without the scene: no elements are assembled, however many (load_outline). \throws
/// SceneError
std::string digest_of(const SceneSource& source);

/// Whether a word for scenes is a path, "own.toml", "own.toml@1e-4", "own/", "own/*.toml", rather than a name
/// or a glob on names: it contains a slash or ".toml", or is a folder and no scene that ships.
bool names_path(const std::string& word);

/// The scene files behind a path: the file itself, every TOML file of a folder, or every file that matches,
/// sorted by name; of a family each level unless one is given. \throws NothingMatched where a folder or a
/// glob holds none, SceneError for a file that is missing or cannot be read
std::vector<SceneSource> scene_files(const std::string& path);

/// What --scenes asks for: any number of words A*:B*:own.toml:folder-C*, each a name, a glob on names or a
/// path, then, after the first dash that follows `*`, `?` or `:`, globs on names that are left out.
class SceneFilter {
 public:
  /// No word: every scene. \throws NothingMatched, SceneError as `scene_files`
  explicit SceneFilter(const std::vector<std::string>& words);

  /// Whether a scene that is not asked for by its file belongs.
  [[nodiscard]] bool takes(std::string_view name) const;
  /// Whether a scene is left out by its name, asked for by its file or not.
  [[nodiscard]] bool leaves_out(std::string_view name) const;
  /// Globs on names that a scene must match one of; none: every scene, unless there are `files`.
  [[nodiscard]] const std::vector<std::string>& globs() const { return globs_; }
  /// Asked for by path, in their order, each once.
  [[nodiscard]] const std::vector<SceneSource>& files() const { return files_; }

 private:
  std::vector<std::string> globs_, left_out_;
  std::vector<SceneSource> files_;
};

/// How many scenes a file with ranges stands for.
struct Instances {
  int count = 0;           ///< 1 to `count` of a seed; 0: the scene as it is written
  std::uint64_t seed = 1;  ///< of the numbers that are drawn
};

/// How many scenes a suite holds, instances of files with ranges included; none is assembled. \throws
/// SceneError
std::size_t count_scenes(const Suite& suite, std::span<const SceneSource> sources);

/// The scenes that a filter names by path, in their order, then those of the suite that it takes, files of
/// the suite's own first, the others in the order of `sources`; last those that ship and no suite holds,
/// where a glob takes none of the suite's. Two scenes of one name are refused: records could not tell them
/// apart. Of a file with ranges as many instances as asked for. \throws NothingMatched for a glob without a
/// scene, UsageError, SceneError
std::vector<Scene> choose_scenes(const Suite& suite, const std::vector<std::string>& words,
                                 std::span<const SceneSource> sources, const Instances& instances = {});

}  // namespace signorini
