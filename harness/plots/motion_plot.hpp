#pragma once
// An answer as `solve --plot` draws it.

#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// Displacement with its stop, velocity, and impulse of the contact force so far over one period, and the
/// portrait of velocity over displacement with the stop as a wall; the answer over the certified orbit behind
/// it, if there is one, whose impacts are marked. Of the contact that exchanges most impulse.
/// \param waveforms  of the record's answer, at least one contact
Figure motion_plot(const Scene& scene, const Record& record, const Waveforms& waveforms,
                   Column column = Column::own);

}  // namespace signorini
