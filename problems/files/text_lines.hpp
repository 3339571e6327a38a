#pragma once
// Text files of numbers, line by line, and what is wrong with them.

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace signorini {

/// Blanks within a line.
inline constexpr std::string_view kBlanks = " \t\r\v\f";

/// The words of a line, which characters of `between` part.
std::vector<std::string_view> words_of(std::string_view line, std::string_view between = kBlanks);

/// The whole word as a number, or nothing.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The number of a word with an exponent as Fortran writes it, 1.5D+03 or 1.5-103; nothing for any other
/// word.
std::optional<double> fortran_number(std::string_view word);

/// The lines of a text, taken apart, with their numbers; a byte order mark at its head is left out. All that
/// refuses throws SceneError in the form `NAME:LINE: what = found (required)`, of one line whatever the text
/// holds.
class TextLines {
 public:
  /// \param text     outlives this
  /// \param name     of the file; outlives this
  /// \param between  the characters that part words
  TextLines(std::string_view text, const std::string& name, std::string_view between = kBlanks);

  /// Goes on to the next line that has a word; false at the end. \throws SceneError for a line above 1 MiB
  bool next();
  /// Goes on to the next line, of at least so many words. \throws SceneError where it is not there
  const std::vector<std::string_view>& expect(std::string_view what, std::size_t words);

  /// Of the line.
  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  /// The line as it stands.
  [[nodiscard]] std::string_view line() const { return line_; }
  /// Name of the file.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The number of the line, from 1.
  [[nodiscard]] int number() const { return number_; }

  /// A word of the line as a whole number within a range. \throws SceneError
  [[nodiscard]] std::int64_t whole(std::size_t word, std::string_view what, std::int64_t least,
                                   std::int64_t most) const;
  /// A word of the line as a number within -1e60..1e60. \throws SceneError
  [[nodiscard]] double finite(std::size_t word, std::string_view what) const;

  /// Refuses at the line, or at another one.
  [[noreturn]] void refuse(std::string_view what, std::string_view found, std::string_view required,
                           std::optional<int> number = {}) const;
  /// Refuses the line, of which the message shows the beginning.
  [[noreturn]] void refuse(std::string_view what, std::string_view required) const;

 private:
  std::string_view rest_;  // what has not been read
  const std::string& name_;
  std::string_view between_;
  std::string_view line_ = {};
  std::vector<std::string_view> words_ = {};
  int number_ = 0;
};

}  // namespace signorini
