#pragma once
// The orbits of results/references as references of a run.

#include <filesystem>
#include <optional>

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
/// it.
std::optional<Reference> kept_reference(const Scene& scene, const std::filesystem::path& folder,
                                        const OrbitPolisher& polish);

}  // namespace signorini
