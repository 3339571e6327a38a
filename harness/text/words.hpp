#pragma once
// Words in one text and apart. Compiled once: fmt::join and the string algorithms of Boost take one to three
// seconds wherever they are called.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// The words in one text, with `between` from one to the next.
std::string joined(std::span<const std::string> words, std::string_view between);

/// Numbers as fmt prints them by `format`, such as "{:.4g}", likewise.
std::string joined(std::span<const double> numbers, std::string_view format, std::string_view between);

/// What stands between the separators: one word more than there are separators, some of them empty.
std::vector<std::string> split(std::string_view text, char separator);

/// Broken at blanks into lines of at most `width` bytes; a word that is longer stands alone. At least one
/// line.
std::vector<std::string> wrapped_lines(const std::string& text, std::size_t width);

/// A finite number rounded to so many significant decimal digits, as it is printed. Unchanged where that is
/// beyond the largest number. \param digits  1..17
double rounded(double value, int digits);
/// All of them.
std::vector<double> rounded(std::vector<double> values, int digits);

/// The text with every `from`, which is not empty, replaced by `to`, read once from the left.
std::string replaced(std::string_view text, std::string_view from, std::string_view to);

/// Folders that an environment variable lists, such as PATH: what stands between its colons; none where it is
/// unset.
std::vector<std::string> folders_of(const char* variable);

/// Text inside HTML or XML and inside their attributes: what would be markup is spelled out, control
/// characters but ends of lines and tabs are blanks.
std::string html_escaped(std::string text);

}  // namespace signorini
