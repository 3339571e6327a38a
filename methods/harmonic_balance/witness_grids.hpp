#pragma once
// Grids of hat functions whose motion stands beside that of harmonic balance.

#include <optional>

#include "methods/refinement.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The scene on hat functions with restitution 1, the law that the projected force represents whatever the
/// scene's. Empty where it has too many contacts for as many nodes. `problem` must outlive the result.
std::optional<Resolutions> witness_grids(const Problem& problem);

/// Whether a grid of so many nodes carries the harmonics of `receptance` (4 nodes each) and is not too large.
bool carries_harmonics(int nodes, const ContactReceptance& receptance);

}  // namespace signorini
