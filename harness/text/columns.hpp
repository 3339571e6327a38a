#pragma once
// Tables as a terminal shows them.

#include <cstddef>
#include <string>

#include "harness/table.hpp"

namespace signorini {

/// Columns of a terminal that is asked for nothing.
inline constexpr std::size_t kTerminalWidth = 80;

/// Columns two blanks apart: words at the left, numbers at the right of their column; no blanks at the ends
/// of lines. Where a line has more than `width` characters, the widest columns of words are broken at blanks,
/// as far as their longest words allow.
std::string to_columns(const Table& table, std::size_t width = std::string::npos);

}  // namespace signorini
