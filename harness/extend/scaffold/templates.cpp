#include "harness/extend/scaffold/templates.hpp"

#include <algorithm>
#include <cassert>

namespace signorini {

std::string filled(std::string_view text, const Places& places) {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = text.find("{{");
    result += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto place =
        std::find_if(places.begin(), places.end(), [&](const auto& one) { return one.first == name; });
    assert(place != places.end());
    result += place->second;
    text.remove_prefix(close + 2);
  }
  while (result.ends_with("\n\n")) result.pop_back();
  return result;
}

}  // namespace signorini
