#pragma once
// The layout of a scene and what its stops are made of, without its matrices.

#include <filesystem>
#include <string>
#include <vector>

#include "problems/damped_stops.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/system_layout.hpp"

namespace signorini {

/// What is known of a scene without its matrices.
struct SceneOutline {
  int coordinates = 0;                            ///< Nd
  SystemLayout layout = {};                       ///< which coordinates what is named there has
  std::vector<std::filesystem::path> files = {};  ///< as SceneWithSources::files
  /// What the readers of the files of its matrices decided, a line each: sums of repeated entries, what a
  /// symmetric part leaves out, supports by penalty.
  std::vector<std::string> notices = {};
  /// The stops that are springs with dampers, one per contact; none where they are not.
  std::vector<DampedStop> damped_stops = {};
};

/// Reads no more than this: no elements are assembled. \throws SceneError as load_scene does for what it
/// reads
SceneOutline load_outline(const SceneSource& source);

}  // namespace signorini
