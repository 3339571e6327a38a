#pragma once
// The orbits of results/references as references of a run.

#include <filesystem>
#include <optional>
#include <string>

#include "harness/judge/orbit_solver.hpp"
#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

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
