#pragma once
// Hat functions on finer and finer grids.

#include <memory>
#include <optional>

#include "methods/hat_functions/hat_contact.hpp"
#include "methods/refinement.hpp"

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

/// The scene on those grids, one after another, until two agree within 5 % (`refined_until_agreed`). A grid
/// dissipates or feeds the motion at impacts, at a rate that falls with N, so that an answer on one grid
/// alone may be of another motion (docs/decisions/0014). Motions below 1e-6 of the static deflection are at
/// rest; a grid that would take more than about a second is not asked. \throws std::runtime_error if the
/// structure cannot be factorised
std::unique_ptr<PreparedMethod> refined_hat_contact(const Problem& problem, const HatSettings& settings,
                                                    std::optional<double> restitution);

}  // namespace signorini
