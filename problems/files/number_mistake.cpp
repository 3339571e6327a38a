#include "problems/files/number_mistake.hpp"

#include <algorithm>

namespace signorini {

std::string number_mistake(std::string_view text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view here = text.substr(i, 3);
    const bool minus = here == "\xE2\x88\x92" || here == "\xE2\x80\x93" || here == "\xE2\x80\x94";
    if (minus && (digit(i + 3) || text.substr(i + 3).starts_with('.')))
      return "; the minus sign is one of a text processor: write -";
    if (text[i] == ',' && i > 0 && digit(i - 1) && digit(i + 1))
      return "; a decimal comma: write a point, as in 1.5";
  }
  return "";
}

std::string toml_number_mistake(std::string_view line) {
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find('='); at != std::string_view::npos; at = line.find('=', at + 1)) {
    std::string_view value = line.substr(at + 1);
    value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
    value = value.substr(0, value.find_first_not_of("+-.,0123456789"));
    if (std::string mistake = number_mistake(value); !mistake.empty()) return mistake;
  }
  std::string without_commas(line);
  std::ranges::replace(without_commas, ',', ' ');
  return number_mistake(without_commas);
}

}  // namespace signorini
