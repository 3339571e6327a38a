#include "harness/report/document/lines.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "harness/text/words.hpp"

namespace signorini {

std::string plural(std::ptrdiff_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string with_unit_signs(const std::string& text) {
  constexpr std::string_view kPlain = " us";
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  std::string signs = text;
  for (std::size_t at = signs.find(kPlain, 1); at != std::string::npos; at = signs.find(kPlain, at + 1)) {
    const std::size_t end = at + kPlain.size();
    if (is_digit(signs[at - 1]) && (end == signs.size() || !is_letter(signs[end])))
      signs.replace(at, kPlain.size(), " µs");
  }
  return signs;
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
