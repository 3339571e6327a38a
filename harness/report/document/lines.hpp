#pragma once
// Text in lines of limited width. Widths are in bytes, which are at least the characters.

#include <cstddef>
#include <string>

namespace signorini {

/// "1 case", "2 cases".
std::string plural(std::ptrdiff_t count, const char* noun);

/// Microseconds of time_text with their sign: "59.4 us, 17 of 17" as "59.4 µs, 17 of 17".
std::string with_unit_signs(const std::string& text);

/// The text beside a name, in lines of at most `width` that begin below each other in column `indent`, each
/// ended: "law       rigid stops\n". A name of `indent` characters or more is not parted from the text.
std::string named_lines(const std::string& name, std::size_t indent, const std::string& text,
                        std::size_t width);

/// Not longer than `width`, at least 3: what is too much gives way to "...".
std::string clipped(const std::string& text, std::size_t width);

}  // namespace signorini
