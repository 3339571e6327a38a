#pragma once
// The cells of one record in tables.

#include <cstddef>
#include <string>
#include <string_view>

#include "harness/records/record.hpp"
#include "harness/table.hpp"

namespace signorini {

/// A number of things, which sorts as one.
Cell count_cell(std::ptrdiff_t count);

/// "22 of 24", which sorts by the first.
Cell count_cell(std::ptrdiff_t count, std::ptrdiff_t all);

/// "22 of 24, 0.31 ms": so many of them, and their median time, without it where half or more have none; it
/// sorts by the time.
Cell count_cell(std::ptrdiff_t count, std::ptrdiff_t all, double seconds);

/// A number as fmt prints it by `format`, such as "{:.1e}", by which the cell sorts; other words where there
/// is none, or an infinite one.
Cell number_cell(const Measure& value, std::string_view format, const std::string& missing = "-");

/// The same of a time, as time_text has it [s].
Cell time_cell(const Measure& seconds, const std::string& missing = "-");

/// The status in parentheses, for cells of a run without an answer: "(timeout)".
std::string in_place(Status status);
std::string in_place(const Record& record);

/// The relative error of x as tables print it: two digits, `<` and what is known of the orbit where the error
/// is below that; "near: 2.7e-01" of an answer that is near an orbit, but not certified by it. Where there is
/// none, the reason.
std::string error_text(const Record& record);

/// An error against the certified orbit, "<" and ten error bars of that orbit where it is smaller.
std::string bounded_text(double error, const Record& record);

/// "0.31 ms" and so on.
std::string time_text(double seconds);

/// "12 stable, 5 unstable": of so many motions; the rest is not determined. "-" of none.
std::string stability_text(int stable, int unstable, int all);

/// same | other (orbit) | certified without a reference, each with the orbit's stability and whether it
/// touches nothing | uncertified, with reasons.
std::string orbit_text(const Record& record);

}  // namespace signorini
