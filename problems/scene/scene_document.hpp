#pragma once
// The steps between a scene file and its Problem, for readers that change the document in between.

#include <filesystem>
#include <string>

#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_family.hpp"

namespace signorini {

struct SceneWithSources;

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

}  // namespace signorini
