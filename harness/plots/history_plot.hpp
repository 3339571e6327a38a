#pragma once
// Runs of one suite over time as `history --plot` draws them.

#include "harness/compare/history.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// Three panels below each other over the runs by date: the share of cases certified, the median error, the
/// mean time; dates and commits below. Requires at least one run.
Figure history_plot(const History& history, Column column = Column::own);

}  // namespace signorini
