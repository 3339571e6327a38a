#pragma once
// Orbits as JSON, and the files of results/references: docs/records.md gives every key.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/orbits/orbit_search.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

/// The certified orbits of one scene, and the search that they come from.
struct OrbitFile {
  std::string scene = {};
  std::string scene_sha256 = {};
  RepresentedLaw law = {};          ///< the scene's own
  OrbitSearchOptions options = {};  ///< its time limit is not kept
  std::vector<FoundOrbit> orbits = {};
};

/// The file of what a search of a scene found.
OrbitFile make_orbit_file(const Scene& scene, const OrbitSearchOptions& options, const SceneOrbits& found);

/// One orbit; absent keys are notions that it does not have.
nlohmann::ordered_json to_json(const FoundOrbit& orbit);

/// The file's text: one orbit per line, ends in a line feed. Nothing of the machine is in it.
std::string print_orbit_file(const OrbitFile& file);

/// Reads what `print_orbit_file` wrote; the motions themselves are not in it. `name` stands for the file.
/// \throws UsageError `NAME: what is wrong`, one line
OrbitFile parse_orbit_file(const std::string& text, const std::string& name);

}  // namespace signorini
