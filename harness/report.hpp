#pragma once
// Tables of records: pure functions of the records, the same bytes whatever their order and the machine.

#include <string>
#include <vector>

#include "harness/record.hpp"

namespace signorini {

/// Markdown: the summary per method, one row per record, then what went wrong in full.
std::string markdown_report(const std::vector<Record>& records);

/// One row per record with all measures as plain numbers. An empty cell is explained in the last column.
std::string csv_report(const std::vector<Record>& records);

/// "e = 0.8", "k = 1e+06 N/m", "massless", "undetermined", "no contact".
std::string law_text(const RepresentedLaw& law);

/// The relative error of x as tables print it: two digits, and `<` ten error bars where it is below that.
/// Where there is none, the reason.
std::string error_text(const Record& record);

/// An error against the certified orbit, "<" and ten error bars of that orbit where it is smaller.
std::string bounded_text(double error, const Record& record);

/// "0.31 ms" and so on.
std::string time_text(double seconds);

/// same | other (orbit) | certified without a reference | uncertified, with reasons.
std::string orbit_text(const Record& record);

}  // namespace signorini
