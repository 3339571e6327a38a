#pragma once
// Hat functions on finer and finer grids.

#include <optional>

#include "methods/hat_functions/hat_contact.hpp"
#include "methods/resolutions.hpp"

namespace signorini {

/// Nodes of the finest grid that is tried unasked.
constexpr int kFinestHatGrid = 4096;

/// Nodes of the first grid: 256, doubled until there are 16 per oscillation of the load's highest harmonic,
/// as far as the finest grid has them.
int coarsest_hat_grid(const Problem& problem);

/// The scene on the coarsest grid and on four times as many nodes, up to the finest.
/// \param settings  of all grids but for the nodes
/// \param restitution  as of hat_contact; `problem` must outlive the grids
Resolutions hat_grids(const Problem& problem, const HatSettings& settings, std::optional<double> restitution);

}  // namespace signorini
