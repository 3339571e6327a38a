#pragma once
// The layout of a scene and what its stops are made of, without its matrices.

#include <string>
#include <vector>

#include "problems/damped_stops.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/system_layout.hpp"

namespace signorini {

/// The stops of a scene that are springs with dampers, one per contact; none where they are not. \throws
/// SceneError as load_scene does for what it reads
std::vector<DampedStop> load_damped_stops(const SceneSource& source);

/// Reads the [system] table of a scene alone. \throws SceneError as load_scene does for what it reads
SystemLayout load_layout(const SceneSource& source);

/// What the readers of the files of its matrices decided, a line each: sums of repeated entries, what a
/// symmetric part leaves out, supports by penalty. \throws SceneError as load_scene does for what it reads
std::vector<std::string> load_notices(const SceneSource& source);

}  // namespace signorini
