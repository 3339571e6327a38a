#include "harness/report/document/lines.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace signorini {

std::string plural(std::ptrdiff_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string with_unit_signs(const std::string& text) {
  static const std::regex plain("([0-9]) us\\b");
  return std::regex_replace(text, plain, "$1 µs");
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

std::string named_lines(const std::string& name, std::size_t indent, const std::string& text,
                        std::size_t width) {
  std::string lines;
  for (const std::string& line : wrapped_lines(text, width - indent))
    lines += fmt::format("{:<{}}{}\n", lines.empty() ? name : "", indent, line);
  return lines;
}

std::string clipped(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  std::size_t end = width - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // no half characters
  return text.substr(0, end) + "...";
}

}  // namespace signorini
