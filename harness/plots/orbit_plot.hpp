#pragma once
// All orbits of a scene as `orbits --plot` draws them.

#include "harness/orbits/orbit_search.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// A portrait of each orbit, velocity over displacement of the contact that moves most, with its stop as a
/// wall: order and stability in the title, at most 12, in the order of the search. Then the Floquet
/// multipliers of all in the complex plane, and the share of the starts of the search that ended at each.
/// \throws UsageError where there is none
Figure orbit_plot(const Problem& problem, const std::vector<FoundOrbit>& orbits, Column column = Column::own);

}  // namespace signorini
