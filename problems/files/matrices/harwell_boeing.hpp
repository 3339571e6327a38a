#pragma once
// Square matrices in the Harwell-Boeing exchange format and in its successor, Rutherford-Boeing.

#include <string>
#include <string_view>

#include "problems/files/matrices/matrix_entries.hpp"

namespace signorini {

/// Whether one of the first three lines with content says so: its first word is the type of a matrix, such as
/// RSA, and whole numbers follow, its sizes.
bool is_harwell_boeing(std::string_view text, const std::string& name);

/// Reads one real, assembled matrix (types R or I; S, Z, U or R; A), in columns of the widths that the file's
/// Fortran formats say [duff1989]. \throws SceneError `NAME:LINE: what = found (what is required)` for
/// another type, a rectangular matrix, a format without field width, and what is no sound number
MatrixFile read_harwell_boeing(std::string_view text, const std::string& name);

}  // namespace signorini
