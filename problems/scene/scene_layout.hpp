#pragma once
// The layout of a scene, without its matrices.

#include "problems/scene/scene_file.hpp"
#include "problems/scene/system_layout.hpp"

namespace signorini {

/// Reads the [system] table of a scene alone. \throws SceneError as load_scene does for what it reads
SystemLayout load_layout(const SceneSource& source);

}  // namespace signorini
