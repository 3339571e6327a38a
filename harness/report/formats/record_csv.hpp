#pragma once
// Records as a spreadsheet takes them.

#include <string>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// One row per record with all measures as plain numbers. An empty cell is explained in the last column.
std::string csv_report(const Evaluation& evaluation);

/// One row per scene and configuration: its eligibility (competes, another-law, not-applicable), how many of
/// its runs are solved, and seconds to each error of kErrorLevels; `inf` where it is not reached.
std::string measures_csv(const Evaluation& evaluation);

}  // namespace signorini
