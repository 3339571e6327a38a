#pragma once
// The [system] table of a scene file: which kind of structure, and its matrices.

#include <string>

#include "problems/scene/scene_field.hpp"
#include "problems/scene/system_description.hpp"

namespace signorini {

/// \throws SceneError for anything but a sound [system] table
SystemDescription read_system(const SceneField& system);

/// The field of the document that a matrix path of validate() ("system.mass") stands for in a system of its
/// kind; other paths as they are.
SceneField system_field_as_written(const SceneField& document, const std::string& path);

}  // namespace signorini
