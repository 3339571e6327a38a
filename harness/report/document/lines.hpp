#pragma once
// Text in lines of limited width. Widths are in bytes, which are at least the characters.

#include <cstddef>
#include <string>
#include <vector>

namespace signorini {

/// Broken at blanks into lines of at most `width`; a word that is longer stands alone. At least one line.
std::vector<std::string> wrapped_lines(const std::string& text, std::size_t width);

/// Not longer than `width`, at least 3: what is too much gives way to "...".
std::string clipped(const std::string& text, std::size_t width);

}  // namespace signorini
