#pragma once
// A motion that need not be periodic as `motion --plot` draws it.

#include "harness/motion/long_motion.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"
#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The displacement of the contact that moves most over time, and below it the stroboscopic section: its
/// velocity over its displacement at the beginning of each forcing period; with its stops.
/// \param waveform  over some periods, sampled anew
/// \throws UsageError where the scene has no contact, or nothing was measured
Figure section_plot(const Problem& problem, const LongMotion& motion, const Trajectory& waveform,
                    Column column = Column::own);

}  // namespace signorini
