#include "problems/files/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/files/toml_tree.hpp"

namespace signorini {

std::vector<std::string_view> words_of(std::string_view line, std::string_view between) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(between);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    words.push_back(line.substr(0, line.find_first_of(between)));
    line.remove_prefix(words.back().size());
  }
}

std::optional<double> fortran_number(std::string_view word) {
  constexpr std::size_t kLongest = 64;
  if (word.size() > kLongest) return std::nullopt;
  std::string text(word);
  const std::size_t letter = text.find_first_of("dD");
  if (letter != std::string::npos)
    text[letter] = 'e';
  else if (const std::size_t sign = text.find_last_of("+-"); sign != std::string::npos && sign > 0)
    text.insert(sign, "e");
  return number_of<double>(text);
}

TextLines::TextLines(std::string_view text, const std::string& name, std::string_view between)
    : rest_(text), name_(name), between_(between) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextLines::next() {
  constexpr std::size_t kLongest = std::size_t{1} << 20U;  // [bytes]
  while (!rest_.empty()) {
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(rest_.size(), line_.size() + 1));
    ++number_;
    if (line_.size() > kLongest)
      refuse("line", fmt::format("{} bytes", line_.size()), fmt::format("must have at most {}", kLongest));
    words_ = words_of(line_, between_);
    if (!words_.empty()) return true;
  }
  return false;
}

const std::vector<std::string_view>& TextLines::expect(std::string_view what, std::size_t words) {
  if (!next()) refuse(what, "missing", "must be there");
  if (words_.size() < words) refuse(what, fmt::format("must have {} words", words));
  return words_;
}

std::int64_t TextLines::whole(std::size_t word, std::string_view what, std::int64_t least,
                              std::int64_t most) const {
  const auto number = word < words_.size() ? number_of<std::int64_t>(words_[word]) : std::nullopt;
  if (!number || *number < least || *number > most)
    refuse(what, fmt::format("word {} must be a whole number in {}..{}", word + 1, least, most));
  return *number;
}

double TextLines::finite(std::size_t word, std::string_view what) const {
  constexpr double kLargest = 1e60;  // fourth powers of it are numbers
  const auto number = word < words_.size() ? number_of<double>(words_[word]) : std::nullopt;
  if (!number || !(std::abs(*number) <= kLargest))
    refuse(what, fmt::format("word {} must be a number within -1e60..1e60", word + 1));
  return *number;
}

void TextLines::refuse(std::string_view what, std::string_view found, std::string_view required,
                       std::optional<int> number) const {
  throw SceneError(fmt::format("{}:{}: {} = {} ({})", name_, std::max(number.value_or(number_), 1), what,
                               found, required));
}

void TextLines::refuse(std::string_view what, std::string_view required) const {
  constexpr std::size_t kEnough = 64;
  std::string text;  // words parted by one blank: a line may be long and hold control characters
  for (const std::string_view word : words_) {
    if (text.size() > kEnough) break;
    text += fmt::format("{}{}", text.empty() ? "" : " ", word.substr(0, kEnough));
  }
  refuse(what, fmt::format("\"{}\"", one_line(text)), required);
}

}  // namespace signorini
