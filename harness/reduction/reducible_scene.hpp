#pragma once
// A scene to be reduced, without the damping ratios of its modes.

#include <vector>

#include "problems/scene/scene_file.hpp"

namespace signorini {

/// A scene of any size. Damping ratios of modes make D a full matrix, which few structures are small enough
/// for; a reduced one is, and takes them in its turn.
struct ReducibleScene {
  Problem problem = {};             ///< without damping where there are ratios
  std::vector<double> ratios = {};  ///< of modes by rising frequency, the last for all further; or none [-]
};

/// \throws SceneError as load_scene does, and for ratios beside dampers
ReducibleScene read_reducible(const SceneSource& source);

}  // namespace signorini
