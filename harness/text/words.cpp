#include "harness/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace signorini {

std::string joined(std::span<const std::string> words, std::string_view between) {
  return fmt::format("{}", fmt::join(words, between));
}

std::string joined(std::span<const double> numbers, std::string_view format, std::string_view between) {
  return fmt::format(fmt::runtime(format), fmt::join(numbers, between));
}

std::vector<std::string> wrapped_lines(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::vector<std::string> lines(1);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  const double read = std::strtod(text.c_str(), nullptr);  // std::stod throws at the least numbers
  return std::isfinite(read) ? read : value;
}

std::vector<double> rounded(std::vector<double> values, int digits) {
  for (double& value : values) value = rounded(value, digits);
  return values;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> words;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  words.emplace_back(text);
  return words;
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string written;
  for (std::size_t at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
    written.append(text.substr(0, at)).append(to);
    text.remove_prefix(at + from.size());
  }
  return written.append(text);
}

std::vector<std::string> folders_of(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr || *value == '\0' ? std::vector<std::string>() : split(value, ':');
}

std::string html_escaped(std::string text) {
  // Control characters, which HTML forbids.
  std::ranges::replace_if(
      text, [](unsigned char c) { return (c < 0x20U && c != '\n' && c != '\t') || c == 0x7FU; }, ' ');
  // The ampersand first: the others are spelled with it.
  for (const auto& [plain, spelled] :
       {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    text = replaced(text, plain, spelled);
  return text;
}

}  // namespace signorini
