#pragma once
// The orbits of a scene as they are kept: their file, their comparison with what a search finds now, and the
// reference that they make for a run.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/orbit_solver.hpp"
#include "harness/judge/reference.hpp"
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

/// Instants may differ by this many times the sum of both error bars, plus kInstantFloor, in periods;
/// impulses by as much relative to the largest, amplitudes and multipliers relative to themselves (a
/// multiplier below 1 to 1).
inline constexpr double kErrorBars = 100.0;
inline constexpr double kInstantFloor = 1e-8;
/// The weak impacts before a complete chatter, below this share of the largest impulse, are not compared.
inline constexpr double kWeakEvent = 1e-3;

struct OrbitDifferences {
  std::vector<std::string> differences = {};  ///< what was kept and is not so any more, one line each
  std::vector<std::string> fresh = {};        ///< orbits that were not kept
};

/// Every orbit kept must be there again: order, fingerprint, events, amplitude, multipliers, stability, and
/// whether it is the one from rest. Events are compared after the shift by whole forcing periods that
/// brings them nearest. Another scene file or law is one difference, and nothing else is compared then.
OrbitDifferences compare_orbits(const OrbitFile& kept, const OrbitFile& now);

/// results/references below the current folder, or below the nearest folder above it that has one; the former
/// if there is none.
std::filesystem::path references_folder();

/// The orbit from rest that `folder`/SCENE.json keeps of this very scene (by its hash), under the scene's own
/// law, rebuilt from its events. It is known to 1e-9 at least; CVODE, which confirmed it when it was kept,
/// does not follow it again. Empty where none is kept, the file is not readable, or the events do not lead to
/// it before the deadline.
std::optional<Reference> kept_reference(const Scene& scene, const std::filesystem::path& folder,
                                        const OrbitPolisher& polish, Deadline deadline);

/// SHA-256 of the file in which orbits of the scene are kept, empty where there is none: records of runs with
/// and without it differ in `same_orbit`.
std::string kept_reference_digest(const Scene& scene, const std::filesystem::path& folder);

}  // namespace signorini
