#pragma once
// Lines of text files of numbers, taken apart.

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace signorini {

/// Blanks within a line.
inline constexpr std::string_view kBlanks = " \t\r\v\f";

/// The words of a line, which characters of `between` part.
inline std::vector<std::string_view> words_of(std::string_view line, std::string_view between = kBlanks) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(between);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(between)));
    line.remove_prefix(words.back().size());
  }
}

/// The whole word as a number, or nothing.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace signorini
